// What a run's sink makes of ticks that did not happen yet, and of a stop.

#include "engine/app/run/run_sink.h"

#include <gtest/gtest.h>

#include "engine/app/picture/bridge.h"
#include "haptics/safety/faults.h"
#include "haptics/safety/guard.h"

namespace fulcrum::test {
namespace {

class RunSinkTest : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(stick_); }

  TickEvent event(bool stopped) {
    TickEvent event;
    event.record.tick = tick_++;
    event.record.X_WT = stick_->haptic.scene.tool.X_WT_start;
    event.record.stopped = stopped;
    return event;
  }

  const std::optional<app::Prepared> stick_ = app::prepare("stick", std::vector<std::string>());
  std::int64_t tick_ = 0;
};

TEST_F(RunSinkTest, BeginsWithTheToolWhereTheSceneHasIt) {
  const app::RunSink sink(*stick_, std::nullopt, 1);
  const ToolDesc& tool = stick_->haptic.scene.tool;
  EXPECT_EQ(sink.last().X_WT.p, tool.X_WT_start.p);
  EXPECT_TRUE((sink.last().X_WH * tool.X_HT).p.isApprox(tool.X_WT_start.p));
  EXPECT_EQ(sink.time(), 0);
}

TEST_F(RunSinkTest, AStopIsAPauseOfTheTrial) {
  app::RunSink sink(*stick_, std::nullopt, 0.1);
  for (int i = 0; i < 60; ++i) sink.take(event(false));
  for (int i = 0; i < 500; ++i) sink.take(event(true));
  EXPECT_EQ(sink.end(), app::RunSink::End::running);
  EXPECT_DOUBLE_EQ(sink.time(), 0.06);
  for (int i = 0; i < 39; ++i) sink.take(event(false));
  EXPECT_EQ(sink.end(), app::RunSink::End::running);
  sink.take(event(false));
  EXPECT_EQ(sink.end(), app::RunSink::End::limit);
  EXPECT_DOUBLE_EQ(sink.finish().time_s, 0.1);
}

TEST_F(RunSinkTest, AStopThatWasAskedForIsNoFault) {
  app::RunSink sink(*stick_, std::nullopt, 1);
  const auto stop = [&](std::uint32_t faults) {
    TickEvent stopped = event(faults != 0);
    stopped.record.faults = faults;
    sink.take(stopped);
    return sink.stopped_by_fault();
  };
  EXPECT_FALSE(stop(kStopRequested));
  EXPECT_FALSE(stop(kStopRequested));
  EXPECT_TRUE(stop(kStopRequested | kDeviceLost));
  EXPECT_TRUE(stop(kStopRequested));  // what asked first is what a tick goes on saying
  EXPECT_FALSE(stop(0));
  EXPECT_TRUE(stop(kSampleStale));
  EXPECT_TRUE(stop(kSampleStale | kStopRequested));
}

TEST_F(RunSinkTest, ForceThatWasNeverAwayDoesNotComeBack) {
  const SceneDesc& scene = stick_->haptic.scene;
  TickRecord record;
  record.force_gain = 0.5;
  const scenario::TaskState none = state_after(stick_->haptic.task, {});
  const auto force = [&] { return app::overlay_state(*stick_, scene, record, {}, none).force; };
  EXPECT_EQ(force(), ui::Force::on);
  record.tick = static_cast<std::int64_t>(2 * kRampIn / scene.tick_s);
  EXPECT_EQ(force(), ui::Force::returning);
  record.stopped = true;
  EXPECT_EQ(force(), ui::Force::stopped);
}

}  // namespace
}  // namespace fulcrum::test
