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
    // Elsewhere, at the first checkpoint from 0.1 s to 0.15 s, and pushed from 0.3 s on.
    for (std::int64_t tick = 0; tick < 500; ++tick) {
      TickEvent event;
      event.record.tick = tick;
      event.record.X_WT.p = stick_->haptic.task.checkpoints[tick >= 100 && tick < 150 ? 0 : 3].position -
                            stick_->haptic.task.touch_point;
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

TEST_F(ReviewTest, ShowsTheTaskAsItStoodThen) {
  review_.go_to(0, sink_);
  EXPECT_EQ(review_.task(sink_).step, 0U);
  EXPECT_FALSE(review_.task(sink_).reached[0]);
  review_.go_to(0.4, sink_);
  EXPECT_EQ(review_.task(sink_).step, 1U);
  EXPECT_TRUE(review_.task(sink_).reached[0]);
  EXPECT_FALSE(review_.task(sink_).completed);
  EXPECT_NEAR(review_.task(sink_).time, 0.4, 1e-12);
}

}  // namespace
}  // namespace fulcrum::app
