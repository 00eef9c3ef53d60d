// A trial's figures against motions and forces whose figures are known on paper.

#include "engine/session/trial_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptics/safety/faults.h"

namespace fulcrum::session {
namespace {

constexpr double kTick = 1e-3;

scenario::TaskDesc two_targets() {
  scenario::TaskDesc task;
  task.checkpoints = {{"first", Vec3(0.1, 0, 0), 0.01}, {"second", Vec3(0.2, 0, 0), 0.01}};
  task.dwell = 0;
  task.touch_point = Vec3(0, 0, 0.05);
  return task;
}

// Judges and measures, tick by tick.
struct Trial {
  explicit Trial(const scenario::TaskDesc& task) : judge(task, kTick), meter(task, kTick) {}

  // The touch point there, pushed by that force.
  void tick(const Vec3& p_WC, double force, bool stopped = false, std::uint32_t faults = 0,
            std::optional<GuidanceRecord> guidance = std::nullopt) {
    TickRecord record;
    record.tick = ticks++;
    record.X_WT.p = p_WC - Vec3(0, 0, 0.05);
    record.contact_F_T_W.force = Vec3(0, force, 0);
    record.depth_max = force > 0 ? 1e-4 * force : 0;
    record.stopped = stopped;
    record.faults = faults;
    record.guidance = guidance;
    judge.judge(record);
    meter.note(record, judge.state());
  }
  TrialMetrics metrics() const { return meter.metrics(judge.state()); }

  std::int64_t ticks = 0;
  scenario::TaskJudge judge;
  TrialMeter meter;
};

TEST(TrialMeter, MeasuresTheWayOfTheTouchPoint) {
  Trial trial(two_targets());
  for (int i = 0; i <= 2000; ++i) trial.tick(Vec3(1e-4 * i, 0, 0), 0);
  const TrialMetrics metrics = trial.metrics();
  EXPECT_NEAR(metrics.path, 0.2, 1e-12);
  EXPECT_TRUE(metrics.completed);
  EXPECT_EQ(metrics.checkpoints_reached, 2);
  EXPECT_EQ(metrics.contact_time, 0);
  EXPECT_EQ(metrics.force_95, 0);
  EXPECT_TRUE(metrics.smoothness);
  ASSERT_EQ(trial.meter.events().size(), 2U);
  EXPECT_EQ(trial.meter.events()[0].text, "first");
  EXPECT_NEAR(trial.meter.events()[0].time, 0.9, 0.002);
  EXPECT_NEAR(trial.meter.events()[1].time, 1.9, 0.002);
}

TEST(TrialMeter, KnowsTheForceThatTimesStayedBelow) {
  Trial trial(two_targets());
  for (int i = 1; i <= 10000; ++i) trial.tick(Vec3::Zero(), 1e-3 * i);  // evenly up to 10 N
  const TrialMetrics metrics = trial.metrics();
  EXPECT_NEAR(metrics.force_mean, 5.0005, 1e-9);
  EXPECT_NEAR(metrics.force_95, 9.5, 0.0101);
  EXPECT_NEAR(metrics.force_peak, 10, 1e-12);
  EXPECT_NEAR(metrics.contact_time, 10, 1e-9);
  EXPECT_NEAR(metrics.force_error, 50.005, 1e-6);
  EXPECT_NEAR(metrics.depth_peak, 1e-3, 1e-12);
}

TEST(TrialMeter, KnowsForcesBeyondItsSteps) {
  Trial trial(two_targets());
  for (int i = 0; i < 1000; ++i) trial.tick(Vec3::Zero(), 5000);
  EXPECT_EQ(trial.metrics().force_95, 5000);
}

TEST(TrialMeter, CountsTouchesOnTheWayAndOnesThatFlutterOnce) {
  Trial trial(two_targets());
  const auto rest = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) trial.tick(Vec3::Zero(), 0);
  };
  trial.tick(Vec3::Zero(), 1);  // the trial begins in contact
  rest(49);
  trial.tick(Vec3::Zero(), 1);  // after 49 ms: still that touch
  rest(51);
  trial.tick(Vec3::Zero(), 1);  // another one
  EXPECT_EQ(trial.metrics().touches_on_the_way, 2);
}

TEST(TrialMeter, ATouchAtTheTargetIsNoneOnTheWay) {
  scenario::TaskDesc task = two_targets();
  task.dwell = 1;
  Trial trial(task);
  for (int i = 0; i < 100; ++i) trial.tick(Vec3(0.1, 0, 0), 0);
  trial.tick(Vec3(0.1, 0, 0), 1);
  EXPECT_EQ(trial.metrics().touches_on_the_way, 0);
  // Nor is one that begins in the very tick in which a target without a dwell counts.
  Trial at_once(two_targets());
  for (int i = 0; i < 100; ++i) at_once.tick(Vec3(0.05, 0, 0), 0);
  at_once.tick(Vec3(0.1, 0, 0), 1);
  EXPECT_EQ(at_once.metrics().touches_on_the_way, 0);
}

TEST(TrialMeter, APauseIsNoPartOfTheTrial) {
  Trial trial(two_targets());
  for (int i = 0; i < 100; ++i) trial.tick(Vec3(0, 0, 0), 0);
  for (int i = 0; i < 500; ++i) trial.tick(Vec3(1, 0, 0), 3, true, std::uint32_t{fault_names()[0].bit});
  for (int i = 0; i < 100; ++i) trial.tick(Vec3(2, 0, 0), 0);
  const TrialMetrics metrics = trial.metrics();
  EXPECT_NEAR(metrics.time, 0.2, 1e-12);
  EXPECT_EQ(metrics.path, 0);
  EXPECT_EQ(metrics.force_peak, 0);
  ASSERT_EQ(trial.meter.events().size(), 1U);
  EXPECT_EQ(trial.meter.events()[0].kind, TrialEvent::Kind::pause) << "somebody asked for it";
  trial.tick(Vec3(2, 0, 0), 0, true, kDeviceLost);
  ASSERT_EQ(trial.meter.events().size(), 2U);
  EXPECT_EQ(trial.meter.events()[1].kind, TrialEvent::Kind::fault);
}

// Named and off it is no matter; asked for in a single tick, be it in a pause or while it only fades, it is.
TEST(TrialMeter, KnowsWhetherThePersonWasLed) {
  const auto guided_by = [](const GuidanceRecord& once, bool stopped) {
    Trial trial(two_targets());
    for (int i = 0; i < 100; ++i) trial.tick(Vec3::Zero(), 0, false, 0, GuidanceRecord());
    EXPECT_FALSE(trial.metrics().guided);
    trial.tick(Vec3::Zero(), 0, stopped, 0, once);
    for (int i = 0; i < 100; ++i) trial.tick(Vec3::Zero(), 0, false, 0, GuidanceRecord());
    return trial.metrics().guided;
  };
  for (const bool stopped : {false, true}) {
    EXPECT_FALSE(guided_by({}, stopped));
    GuidanceRecord asked, fading;
    asked.gain = 0.01;
    fading.level = 0.01;
    EXPECT_TRUE(guided_by(asked, stopped));
    EXPECT_TRUE(guided_by(fading, stopped));
  }
}

TEST(TrialMeter, WhatIsNoNumberCountsForNothing) {
  Trial trial(two_targets());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 100; ++i) trial.tick(Vec3(1e-4 * i, 0, 0), 1);
  for (int i = 0; i < 100; ++i) trial.tick(Vec3(nan, 0, 0), nan);
  for (int i = 0; i < 100; ++i) trial.tick(Vec3(0.0099, 0, 0), std::numeric_limits<double>::infinity());
  const TrialMetrics metrics = trial.metrics();
  EXPECT_NEAR(metrics.path, 0.0099, 1e-12);
  EXPECT_EQ(metrics.force_peak, 1);
  EXPECT_TRUE(std::isfinite(metrics.force_error) && std::isfinite(metrics.force_mean));
}

TEST(TrialMeter, HoldsALongTrialInLittleMemory) {
  Envelope envelope(kTick);
  for (int i = 0; i < 1'000'000; ++i) envelope.add(i == 777'777 ? 2.0 : 1.0);
  EXPECT_LE(envelope.largest().size(), Envelope::kMost);
  EXPECT_GE(envelope.largest().size(), Envelope::kMost / 2 - 1);
  const auto at = static_cast<std::size_t>(777.777 / envelope.interval());
  for (std::size_t i = 0; i < envelope.largest().size(); ++i)
    EXPECT_EQ(envelope.largest()[i], i == at ? 2.0 : 1.0) << i;
}

}  // namespace
}  // namespace fulcrum::session
