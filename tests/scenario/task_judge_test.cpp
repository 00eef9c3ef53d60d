#include "engine/scenario/task_judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "haptics/safety/faults.h"

namespace fulcrum::scenario {
namespace {

const TaskDesc kTask{{{"a", Vec3(0, 0, 0), 0.01}, {"b", Vec3(1, 0, 0), 0.01}}, 0.003, Vec3(0.1, 0, 0)};
constexpr double kTick = 1e-3;

TickRecord record(std::int64_t tick, const Vec3& p_WC) {
  TickRecord result;
  result.tick = tick;
  result.X_WT.p = p_WC - kTask.touch_point;
  return result;
}

void judge(TaskJudge& judge, std::int64_t first, std::int64_t last, const Vec3& p_WC) {
  for (std::int64_t tick = first; tick <= last; ++tick) judge.judge(record(tick, p_WC));
}

const Vec3 kAtA(0, 0.009, 0), kAtB(1, 0, 0), kAway(0, 0.5, 0);

TEST(TaskJudge, ReachesAfterTheDwellTime) {
  TaskJudge task(kTask, kTick);
  judge(task, 0, 9, kAway);
  EXPECT_FALSE(task.state().inside);
  judge(task, 10, 12, kAtA);  // 2 ms since it came in
  EXPECT_EQ(task.state().step, 0u);
  EXPECT_TRUE(task.state().inside);
  EXPECT_DOUBLE_EQ(task.state().dwell_progress, 2.0 / 3.0);
  judge(task, 13, 13, kAtA);  // 3 ms
  EXPECT_EQ(task.state().step, 1u);
  EXPECT_DOUBLE_EQ(task.state().reached[0].value(), 0.013);
  EXPECT_EQ(task.state().dwell_progress, 0);
  EXPECT_FALSE(task.state().completed);
  EXPECT_FALSE(task.completion_time());
}

TEST(TaskJudge, LeavingStartsTheCountAnew) {
  TaskJudge task(kTask, kTick);
  judge(task, 0, 2, kAtA);
  judge(task, 3, 3, kAway);
  EXPECT_EQ(task.state().dwell_progress, 0);
  judge(task, 4, 6, kAtA);
  EXPECT_EQ(task.state().step, 0u);
  judge(task, 7, 7, kAtA);
  EXPECT_EQ(task.state().step, 1u);
}

// A stop is a pause: its ticks are no time of the trial, at a checkpoint or on the way to one.
TEST(TaskJudge, RestsWhileTheForceIsStopped) {
  TaskJudge task(kTask, kTick);
  const auto stopped = [&task](std::int64_t first, std::int64_t last, const Vec3& p_WC) {
    for (std::int64_t tick = first; tick <= last; ++tick) {
      TickRecord still = record(tick, p_WC);
      still.stopped = true;
      task.judge(still);
    }
  };
  judge(task, 0, 9, kAway);
  stopped(10, 109, kAtA);  // nothing is reached in a pause
  EXPECT_FALSE(task.state().inside);
  judge(task, 110, 112, kAtA);
  stopped(113, 200, kAway);  // nor left
  judge(task, 201, 201, kAtA);
  EXPECT_EQ(task.state().step, 1u);
  EXPECT_DOUBLE_EQ(task.state().reached[0].value(), 0.013);
}

TEST(TaskJudge, TellsTheTrialsTime) {
  TaskJudge task(kTask, kTick);
  EXPECT_EQ(task.state().time, 0);
  judge(task, 0, 9, kAway);
  EXPECT_DOUBLE_EQ(task.state().time, 0.009);
  for (std::int64_t tick = 10; tick < 110; ++tick) {
    TickRecord stopped = record(tick, kAway);
    stopped.stopped = true;
    task.judge(stopped);
    EXPECT_DOUBLE_EQ(task.state().time, 0.009);
  }
  judge(task, 110, 113, kAtA);
  EXPECT_DOUBLE_EQ(task.state().time, 0.013);
  judge(task, 114, 117, kAtB);
  judge(task, 118, 200, kAway);  // all is reached: it is over
  EXPECT_DOUBLE_EQ(task.state().time, 0.017);
}

TEST(TaskJudge, TakesTheCheckpointsInOrder) {
  TaskJudge task(kTask, kTick);
  judge(task, 0, 99, kAtB);  // the second one first: counts for nothing
  EXPECT_EQ(task.state().step, 0u);
  judge(task, 100, 103, kAtA);
  EXPECT_EQ(task.state().step, 1u);
  judge(task, 104, 107, kAtB);
  EXPECT_TRUE(task.state().completed);
  EXPECT_EQ(task.state().step, 2u);
  EXPECT_DOUBLE_EQ(task.completion_time().value(), 0.107);
  judge(task, 108, 200, kAway);  // nothing is undone
  EXPECT_TRUE(task.state().completed);
  EXPECT_DOUBLE_EQ(task.completion_time().value(), 0.107);
}

// Two checkpoints in one place: the time spent at the first does not count for the second.
TEST(TaskJudge, CountsEachCheckpointFromItsOwnBeginning) {
  TaskJudge task({{{"a", Vec3(0, 0, 0), 0.1}, {"b", Vec3(0, 0, 0), 0.1}}, 0.003, kTask.touch_point}, kTick);
  judge(task, 0, 3, Vec3::Zero());
  EXPECT_EQ(task.state().step, 1u);
  judge(task, 4, 6, Vec3::Zero());
  EXPECT_EQ(task.state().step, 1u);
  judge(task, 7, 7, Vec3::Zero());
  EXPECT_TRUE(task.state().completed);
}

TEST(TaskJudge, LostTicksNeitherCountNorBreakTheCount) {
  TaskJudge task(kTask, kTick);
  judge(task, 0, 1, kAtA);
  judge(task, 60, 61, kAtA);  // 58 ticks were lost to a stall
  EXPECT_EQ(task.state().step, 1u);
  EXPECT_DOUBLE_EQ(task.state().reached[0].value(), 0.061);
}

// 3 s of ticks of 1/3000 s, whose sum would not come to 3 s exactly.
TEST(TaskJudge, CountsTicksNotSeconds) {
  TaskDesc desc = kTask;
  desc.dwell = 3;
  TaskJudge task(desc, 1.0 / 3000);
  judge(task, 0, 8999, kAtA);
  EXPECT_EQ(task.state().step, 0u);
  judge(task, 9000, 9000, kAtA);
  EXPECT_EQ(task.state().step, 1u);
  EXPECT_DOUBLE_EQ(task.state().reached[0].value(), 3);
}

TEST(TaskJudge, WithoutDwellATouchIsEnough) {
  TaskDesc desc = kTask;
  desc.dwell = 0;
  TaskJudge task(desc, kTick);
  judge(task, 5, 5, kAtA);
  judge(task, 6, 6, kAtB);
  EXPECT_TRUE(task.state().completed);
}

TEST(TaskJudge, TheTouchPointTurnsWithTheTool) {
  TaskJudge task(kTask, kTick);
  TickRecord turned;
  turned.X_WT.q = Quat(Eigen::AngleAxisd(std::acos(-1.0) / 2, Vec3::UnitZ()));
  turned.X_WT.p = Vec3(0, -0.1, 0);  // the touch point, 0.1 m along x of the tool, is at the origin
  for (turned.tick = 0; turned.tick < 4; ++turned.tick) task.judge(turned);
  EXPECT_EQ(task.state().step, 1u);
}

TEST(TaskJudge, NotANumberIsNowhere) {
  TaskJudge task(kTask, kTick);
  judge(task, 0, 2, kAtA);
  judge(task, 3, 3, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(task.state().inside);
  EXPECT_EQ(task.state().step, 0u);
}

TEST(TaskJudge, WithoutCheckpointsThereIsNothingToComplete) {
  TaskJudge task({{}, 3, Vec3::Zero()}, kTick);
  EXPECT_TRUE(task.state().completed);
  EXPECT_FALSE(task.completion_time());
}

// One checkpoint that needs something, and ticks of any kind.
class NeedsTest : public testing::Test {
protected:
  static TaskDesc needing(Needs needs) {
    TaskDesc desc = kTask;
    desc.checkpoints.resize(1);
    desc.checkpoints[0].needs = needs;
    return desc;
  }

  struct Tick {
    Vec3 p_WC = kAtA;
    std::int32_t regions = 0;
    std::uint32_t faults = 0;  // that stop the force; 0: it is on
  };
  TickRecord next(const Tick& tick) {
    TickRecord result = record(tick_++, tick.p_WC);
    result.regions = tick.regions;
    result.faults = tick.faults;
    result.stopped = tick.faults != 0;
    return result;
  }
  void take(TaskJudge& task, int ticks, const Tick& tick) {
    for (int i = 0; i < ticks; ++i) task.judge(next(tick));
  }

private:
  std::int64_t tick_ = 0;
};

TEST_F(NeedsTest, ATouchHasToLast) {
  TaskJudge task(needing(Needs::touch), kTick);
  take(task, 100, {});
  EXPECT_TRUE(task.state().inside);
  EXPECT_NE(task.state().lack, Lack::nothing);
  EXPECT_EQ(task.state().dwell_progress, 0);
  take(task, 3, {.regions = 1});
  EXPECT_EQ(task.state().lack, Lack::nothing);
  EXPECT_DOUBLE_EQ(task.state().dwell_progress, 2.0 / 3.0);
  take(task, 1, {});  // let go: the count begins anew
  take(task, 3, {.regions = 2});
  EXPECT_FALSE(task.state().completed);
  take(task, 1, {.regions = 1});
  EXPECT_TRUE(task.state().completed);
}

TEST_F(NeedsTest, AStopCountsOnceTheForceIsTakenUpAgain) {
  TaskJudge task(needing(Needs::stop), kTick);
  take(task, 100, {});
  EXPECT_NE(task.state().lack, Lack::nothing);
  take(task, 50, {.faults = kStopRequested});
  EXPECT_FALSE(task.state().completed);
  EXPECT_DOUBLE_EQ(task.state().time, 0.099);
  take(task, 3, {});
  EXPECT_EQ(task.state().lack, Lack::nothing);
  EXPECT_FALSE(task.state().completed);
  take(task, 1, {});  // the dwell time after that
  EXPECT_TRUE(task.state().completed);
  EXPECT_DOUBLE_EQ(task.state().reached[0].value(), 0.103);
}

TEST_F(NeedsTest, AStopElsewhereIsNone) {
  TaskJudge task(needing(Needs::stop), kTick);
  take(task, 10, {.p_WC = kAway});
  take(task, 10, {.p_WC = kAway, .faults = kStopRequested});
  take(task, 10, {.p_WC = kAtA, .faults = kStopRequested});  // a handle is led there while it is stopped
  take(task, 100, {});
  EXPECT_EQ(task.state().step, 0u);
  EXPECT_NE(task.state().lack, Lack::nothing);
}

TEST_F(NeedsTest, WhoLeavesHasToStopAgain) {
  TaskJudge task(needing(Needs::stop), kTick);
  take(task, 10, {.faults = kStopRequested});
  take(task, 2, {});
  take(task, 1, {.p_WC = kAway});
  take(task, 100, {});
  EXPECT_EQ(task.state().step, 0u);
  take(task, 1, {.faults = kStopRequested});
  take(task, 4, {});
  EXPECT_TRUE(task.state().completed);
}

TEST_F(NeedsTest, AStopByAFaultIsNone) {
  for (const std::uint32_t faults :
       {std::uint32_t{kDeviceLost}, kDeviceLost | kStopRequested, std::uint32_t{kUnanswered}}) {
    TaskJudge task(needing(Needs::stop), kTick);
    take(task, 10, {});
    take(task, 10, {.faults = faults});
    take(task, 10, {.faults = kDeviceLost | kStopRequested});  // Esc where it is stopped already
    take(task, 100, {});
    EXPECT_EQ(task.state().step, 0u) << faults;
  }
}

// The stop at the first one is none at the second, in the same place.
TEST_F(NeedsTest, EachCheckpointNeedsAStopOfItsOwn) {
  TaskDesc desc = needing(Needs::stop);
  desc.checkpoints.push_back(desc.checkpoints.front());
  TaskJudge task(desc, kTick);
  take(task, 10, {.faults = kStopRequested});
  take(task, 100, {});
  EXPECT_EQ(task.state().step, 1u);
  EXPECT_NE(task.state().lack, Lack::nothing);
}

TickRecord touch(std::int64_t tick, double force) {
  TickRecord result = record(tick, kAway);
  result.contact_F_T_W.force = Vec3(0, -force, 0);
  return result;
}

TaskDesc counting() {
  TaskDesc desc = kTask;
  desc.hard_touch = 0.3;
  return desc;
}

// One that rises above the limit is counted once until it has fallen below 70 % of it; its time is that
// above.
TEST(TaskJudge, CountsHardTouchesWithHysteresis) {
  TaskJudge task(counting(), kTick);
  std::int64_t tick = 0;
  const auto press = [&](std::initializer_list<double> forces) {
    for (const double force : forces) task.judge(touch(tick++, force));
  };
  press({0, 0.1, 0.3});  // not above
  EXPECT_EQ(task.state().hard_touches, 0);
  press({0.31, 0.25, 0.31, 0.22});  // trembling about the limit: one touch
  EXPECT_EQ(task.state().hard_touches, 1);
  EXPECT_DOUBLE_EQ(task.state().hard_touch_time, 0.002);
  press({0.2, 0.29});  // over, and not hard again
  EXPECT_EQ(task.state().hard_touches, 1);
  EXPECT_DOUBLE_EQ(task.state().hard_touch_time, 0.002);
  press({0.5});
  EXPECT_EQ(task.state().hard_touches, 2);
  EXPECT_DOUBLE_EQ(task.state().hard_touch_time, 0.003);
}

TEST(TaskJudge, AForceThatIsNotANumberEndsAHardTouch) {
  TaskJudge task(counting(), kTick);
  task.judge(touch(0, 1));
  task.judge(touch(1, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_DOUBLE_EQ(task.state().hard_touch_time, 0.001);
  task.judge(touch(2, 1));
  EXPECT_EQ(task.state().hard_touches, 2);
}

TEST(TaskJudge, CountsNoTouchesUnlessAsked) {
  TaskJudge task(kTask, kTick);
  task.judge(touch(0, 100));
  EXPECT_EQ(task.state().hard_touches, 0);
  EXPECT_EQ(task.state().hard_touch_time, 0);
}

}  // namespace
}  // namespace fulcrum::scenario
