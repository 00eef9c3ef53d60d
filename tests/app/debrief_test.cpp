// What the screen says of a trial, against ticks that were made up for it.

#include "engine/app/run/debrief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace fulcrum::app {
namespace {

class DebriefTest : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(stick_); }

  // The touch point at a checkpoint, pressed with a force.
  void tick_at(RunSink& sink, std::size_t checkpoint, double force) {
    TickEvent event;
    event.record.tick = tick_++;
    event.record.X_WT.p =
        stick_->haptic.task.checkpoints[checkpoint].position - stick_->haptic.task.touch_point;
    event.record.contact_F_T_W.force = Vec3(0, force, 0);
    event.record.regions = force > 0 ? 1 : 0;
    sink.take(event);
  }

  static ui::Debrief::Row row(const ui::Debrief& debrief, const std::string& name) {
    const auto found = std::ranges::find(debrief.rows, name, &ui::Debrief::Row::name);
    EXPECT_NE(found, debrief.rows.end()) << name;
    return found == debrief.rows.end() ? ui::Debrief::Row{} : *found;
  }

  const std::optional<Prepared> stick_ = prepare("stick", std::vector<std::string>());
  std::int64_t tick_ = 0;
};

TEST_F(DebriefTest, TellsWhatWasReachedAndWhen) {
  RunSink sink(*stick_, std::nullopt, 0.5);
  for (int i = 0; i < 100; ++i) tick_at(sink, 3, 0.5);  // the fourth one is no first
  for (int i = 0; i < 150; ++i) tick_at(sink, 0, 1.25);
  for (int i = 0; i < 250; ++i) tick_at(sink, 3, 0.5);
  ASSERT_EQ(sink.end(), RunSink::End::limit);
  const ui::Debrief shown = debrief(*stick_, sink, {}, false);
  EXPECT_EQ(shown.title, "Time is up after 0.5 s");
  EXPECT_EQ(row(shown, "Time").value, "0.5 s");
  EXPECT_EQ(row(shown, "Checkpoints").value, "1 of 6");
  EXPECT_EQ(row(shown, "Checkpoints").points, "6.67 of 40");
  EXPECT_EQ(row(shown, "Peak force").value, "1.25 N");
  EXPECT_EQ(row(shown, "touch at 80 mm").value, "0.1 s");
  EXPECT_EQ(row(shown, "up").value, "-");
  EXPECT_EQ(row(shown, "up").reason, "not reached");
  EXPECT_FALSE(row(shown, "Time").points);
  EXPECT_EQ(shown.foot, "R starts again; close the window to end.");
}

TEST_F(DebriefTest, SaysThatATrialWasGuided) {
  RunSink sink(*stick_, std::nullopt, 0.2);
  TickEvent event;
  event.record.guidance.emplace().gain = 1;
  sink.take(event);
  EXPECT_TRUE(sink.guided());
  for (int i = 1; i < 200; ++i) tick_at(sink, 0, 0);
  const session::TrialMetrics best = sink.metrics();
  const ui::Debrief shown = debrief(*stick_, sink, {&best}, false);
  EXPECT_EQ(shown.title, "Time is up after 0.2 s, guided: no points");
  for (const ui::Debrief::Row& each : shown.rows) EXPECT_FALSE(each.points) << each.name;
}

TEST_F(DebriefTest, OfACompletedTrialSaysInWhichTime) {
  RunSink sink(*stick_, std::nullopt, 30);
  for (std::size_t checkpoint = 0; checkpoint < stick_->haptic.task.checkpoints.size(); ++checkpoint)
    for (int i = 0; i < 200; ++i)
      if (sink.end() == RunSink::End::running) tick_at(sink, checkpoint, 0.5);
  ASSERT_EQ(sink.end(), RunSink::End::completed);
  EXPECT_EQ(debrief(*stick_, sink, {}, true).title, "Completed in 1.0 s");
  EXPECT_NE(debrief(*stick_, sink, {}, true).foot.find("F10"), std::string::npos);
}

TEST_F(DebriefTest, ComparesWithAnExpert) {
  RunSink sink(*stick_, std::nullopt, 0.5);
  for (int i = 0; i < 500; ++i) tick_at(sink, 0, 0.5);
  session::TrialMetrics expert = sink.metrics();
  expert.completed = true;
  const ui::Debrief shown = debrief(*stick_, sink, {&expert}, false);
  EXPECT_NE(shown.title.find("of 100 points"), std::string::npos) << shown.title;
  EXPECT_EQ(row(shown, "Time").points, "0 of 15") << "it was not completed";
}

TEST_F(DebriefTest, ComparesWithTrialsBefore) {
  RunSink sink(*stick_, std::nullopt, 0.5);
  for (int i = 0; i < 500; ++i) tick_at(sink, 0, 0.5);
  session::TrialMetrics expert = sink.metrics();
  expert.completed = true;
  const double points = session::score(sink.metrics(), &expert).total.value_or(0);
  ASSERT_GT(points, 5);
  EXPECT_NE(debrief(*stick_, sink, {&expert}, false).rows.front().name, "Trial");
  const auto reason = [&](double best, double last) {
    const ui::Debrief::Row trial =
        row(debrief(*stick_, sink, {&expert, EarlierTrials{2, best, last}}, false), "Trial");
    EXPECT_EQ(trial.value, "3");
    return trial.reason;
  };
  EXPECT_EQ(reason(points - 4, 1), "Your best yet, by 4 points; the last one 1.");
  EXPECT_EQ(reason(points, points),
            "As good as your best; the last one " + std::to_string(std::lround(points)) + ".");
  EXPECT_EQ(reason(99, 98), "Your best had 99 points; the last one 98.");
}

}  // namespace
}  // namespace fulcrum::app
