// A trial that is looked back at, against ticks that were made up for it.

#include "engine/app/window/review.h"

#include <gtest/gtest.h>

namespace fulcrum::app {
namespace {

TickRecord record_at(std::int64_t tick) {
  TickRecord record;
  record.tick = tick;
  return record;
}

TEST(Film, HoldsEvenlyChosenTicksInBoundedMemory) {
  Film film(1e-3);
  EXPECT_TRUE(film.empty());
  for (std::int64_t tick = 0; tick < 1'000'000; ++tick)
    film.add(record_at(tick), 1e-3 * static_cast<double>(tick));
  EXPECT_LE(film.frames(), Film::kMost);
  EXPECT_GE(film.frames(), Film::kMost / 2);
  // 1000 s and at most 6000 frames: 0.32 s from one to the next.
  for (const double time : {0.0, 1.0, 123.4, 777.7, 999.9}) {
    const double shown = 1e-3 * static_cast<double>(film.at(time).tick);
    EXPECT_LE(shown, time + 1e-9);
    EXPECT_GT(shown, time - 0.3201);
  }
  EXPECT_EQ(film.at(-5).tick, 0);
}

TEST(Film, OfAShortTrialHasAFrameEveryFiftiethOfASecond) {
  Film film(1e-3);
  for (std::int64_t tick = 0; tick < 90'000; ++tick)
    film.add(record_at(tick), 1e-3 * static_cast<double>(tick));
  EXPECT_EQ(film.frames(), 4500U);
  EXPECT_EQ(film.at(45.0105).tick, 45'000);
  EXPECT_EQ(film.at(1e9).tick, 89'980);
}

class ReviewTest : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(stick_);
    // Elsewhere, in touch at the first checkpoint from 0.1 s to 0.15 s, and pushed from 0.3 s on.
    for (std::int64_t tick = 0; tick < 500; ++tick) {
      const bool there = tick >= 100 && tick < 150;
      TickEvent event;
      event.record.tick = tick;
      event.record.X_WT.p =
          stick_->haptic.task.checkpoints[there ? 0 : 3].position - stick_->haptic.task.touch_point;
      event.record.regions = there ? 1 : 0;
      event.record.contact_F_T_W.force = Vec3(0, tick >= 300 ? 1 : 0, 0);
      sink_.take(event);
      review_.add(event.record, sink_.time());
    }
    ASSERT_EQ(sink_.end(), RunSink::End::limit);
  }

  const std::optional<Prepared> stick_ = prepare("stick", std::vector<std::string>());
  RunSink sink_{*stick_, std::nullopt, 0.5};
  Review review_{1e-3};
};

TEST_F(ReviewTest, BeginsWithTheCardAndGoesBackFromTheEnd) {
  EXPECT_FALSE(review_.is_shown());
  EXPECT_FALSE(review_.timeline(sink_).at_s);
  EXPECT_EQ(review_.timeline(sink_).end_s, sink_.time());
  review_.press(Review::Key::back, sink_, false);
  ASSERT_TRUE(review_.is_shown());
  EXPECT_NEAR(*review_.timeline(sink_).at_s, 0.4, 1e-9);
  EXPECT_NEAR(static_cast<double>(review_.record().tick), 400, 20);
  review_.press(Review::Key::back, sink_, true);
  EXPECT_EQ(*review_.timeline(sink_).at_s, 0) << "not before the beginning";
  review_.press(Review::Key::on, sink_, true);
  EXPECT_EQ(*review_.timeline(sink_).at_s, sink_.time()) << "nor beyond the end";
  review_.press(Review::Key::card, sink_, false);
  EXPECT_FALSE(review_.is_shown());
}

TEST_F(ReviewTest, GoesFromEventToEvent) {
  const auto& events = sink_.meter().events();
  ASSERT_EQ(events.size(), 2U);
  review_.press(Review::Key::before, sink_, false);
  EXPECT_NEAR(*review_.timeline(sink_).at_s, 0.3, 1e-9);
  EXPECT_NE(review_.timeline(sink_).caption.find("touch on the way"), std::string::npos);
  review_.press(Review::Key::before, sink_, false);
  EXPECT_NEAR(*review_.timeline(sink_).at_s, events[0].time, 1e-9);
  EXPECT_NE(review_.timeline(sink_).caption.find("checkpoint: touch at 80 mm"), std::string::npos);
  review_.press(Review::Key::before, sink_, false);
  EXPECT_EQ(*review_.timeline(sink_).at_s, 0);
  for (int i = 0; i < 3; ++i) review_.press(Review::Key::after, sink_, false);
  EXPECT_EQ(*review_.timeline(sink_).at_s, sink_.time());
  EXPECT_EQ(review_.timeline(sink_).marks.size(), 2U);
}

TEST_F(ReviewTest, JumpsToWhereTheDeviceGaveAllItHas) {
  Review review(1e-3);
  for (std::int64_t tick = 0; tick < 500; ++tick) {
    TickRecord record = record_at(tick);
    // From 0.1 s on for 20 ms, with a tick between; again from 0.25 s on.
    if ((tick >= 100 && tick < 120 && tick != 110) || tick == 250) record.faults = kForceClamped;
    if (tick == 400) record.faults = kMotorClamped | kSlewLimited;
    review.add(record, 1e-3 * static_cast<double>(tick + 1));
  }
  std::vector<std::string> words;
  for (const Review::Event& event : review.events(sink_)) words.push_back(event.words);
  EXPECT_EQ(words, (std::vector<std::string>{"checkpoint: touch at 80 mm", "the device's greatest force",
                                             "the device's greatest force", "touch on the way",
                                             "a motor at its limit"}));
  review.go_to(0.5, sink_);
  review.press(Review::Key::before, sink_, false);
  EXPECT_NEAR(*review.timeline(sink_).at_s, 0.401, 1e-9);
  EXPECT_NE(review.timeline(sink_).caption.find("a motor at its limit"), std::string::npos);
}

TEST_F(ReviewTest, PlotsForceTorqueDepthAndSpeedOfTheWholeTrial) {
  EXPECT_TRUE(review_.timeline(sink_).plots.empty()) << "beside the card there is nothing to plot";
  review_.go_to(0.2, sink_);
  const ui::Timeline timeline = review_.timeline(sink_, {2.0, 0.1});
  ASSERT_EQ(timeline.plots.size(), 4U);
  EXPECT_EQ(timeline.plots[0].limit, 2.0);
  EXPECT_EQ(timeline.plots[1].limit, 0.1);
  for (const ui::Timeline::Plot& plot : timeline.plots)
    EXPECT_NEAR(plot.interval_s * static_cast<double>(plot.largest.size()), 0.5, 0.01) << plot.name;
  const auto at = [](const ui::Timeline::Plot& plot, double time) {
    return plot.largest.at(static_cast<std::size_t>(time / plot.interval_s));
  };
  EXPECT_EQ(at(timeline.plots[0], 0.2), 0);
  EXPECT_EQ(at(timeline.plots[0], 0.4), 1) << "N, pushed from 0.3 s on";
}

TEST_F(ReviewTest, LimitsAreThoseOfTheSceneOnTheTool) {
  SceneDesc scene = stick_->haptic.scene;
  scenario::TaskDesc task;
  scene.device.renders_force = true;
  scene.device.max_force = 3;
  scene.mapping.force_scale = 0.5;
  scene.coupling.max_torque = 0.2;
  EXPECT_EQ(plot_limits(scene, task).force_N, 6) << "the device gives half of what the scene pushes with";
  EXPECT_EQ(plot_limits(scene, task).torque_Nm, 0.2);
  task.hard_touch = 1.5;
  EXPECT_EQ(plot_limits(scene, task).force_N, 1.5);
  scene.device.renders_force = false;
  scene.coupling.max_force = 4;
  EXPECT_EQ(plot_limits(scene, {}).force_N, 4);
}

TEST_F(ReviewTest, SaysAtWhichMomentTheExpertIsSeen) {
  ExpertRun expert;
  expert.metrics.time = 2;
  expert.reached.assign(stick_->haptic.task.checkpoints.size(), std::nullopt);
  expert.reached[0] = 1.0;
  expert.way = {{0.0, {}}, {2.0, {}}};
  ASSERT_TRUE(sink_.task().reached[0]);
  const double reached = *sink_.task().reached[0];
  review_.go_to(reached / 2, sink_);
  EXPECT_NEAR(review_.same_part_s(sink_, expert), 0.5, 1e-9);
  EXPECT_NE(review_.timeline(sink_, {}, &expert).caption.find("the expert at 0.5 s"), std::string::npos);
  EXPECT_EQ(review_.timeline(sink_).caption.find("expert"), std::string::npos);
}

TEST_F(ReviewTest, ShowsTheTaskAsItStoodThen) {
  review_.go_to(0, sink_);
  EXPECT_EQ(review_.task(sink_, stick_->haptic.task).step, 0U);
  EXPECT_FALSE(review_.task(sink_, stick_->haptic.task).reached[0]);
  review_.go_to(0.4, sink_);
  EXPECT_EQ(review_.task(sink_, stick_->haptic.task).step, 1U);
  EXPECT_TRUE(review_.task(sink_, stick_->haptic.task).reached[0]);
  EXPECT_FALSE(review_.task(sink_, stick_->haptic.task).completed);
  EXPECT_NEAR(review_.task(sink_, stick_->haptic.task).time, 0.4, 1e-12);
}

}  // namespace
}  // namespace fulcrum::app
