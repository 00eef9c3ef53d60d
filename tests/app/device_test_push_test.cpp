// What a device test may do to motors, and what it makes of what they do.

#include <cmath>

#include "engine/app/device_test/report.h"
#include "tests/app/tested_devices.h"

namespace fulcrum::test {
namespace {

TEST(DeviceTestPush, AFreeHandleGivesWayAlongEachPush) {
  Free device(arm());
  const dt::Findings findings = walk_alone(device);
  EXPECT_EQ(dt::outcome_of(findings), Outcome::good);
  EXPECT_NEAR(measure(part(findings, "samples"), "rate"), 1000, 2);
  EXPECT_EQ(measure(part(findings, "samples"), "age, 99 %"), 0);
  EXPECT_EQ(measure(part(findings, "noise at rest"), "rms y"), 0);
  for (const char* const name : kPushes) {
    const dt::Part& push = part(findings, name);
    EXPECT_EQ(push.outcome, Outcome::good) << push.says;
    EXPECT_GT(measure(push, "moved there"), 4.9);  // mm
    EXPECT_GT(measure(push, "moved back"), 4.9);
    EXPECT_LT(measure(push, "moved there"), 6);
    EXPECT_NEAR(measure(push, "smallest step seen"), 0.03, 1e-9);  // mm, the table's encoder step
  }
  // It all happened within a few centimetres.
  for (const Vec3& place : device.places) EXPECT_LT(place.norm(), 0.05);
}

// The handle of the table, by formulas of its own: m a = F - b v - mu sgn v, and F grows by 1 N in a second.
TEST(DeviceTestPush, AHandleGivesWayAsItsTableSays) {
  const DeviceDesc desc = arm();
  Free device(desc);
  const dt::Findings findings = walk_alone(device);
  ASSERT_EQ(findings.pushes.size(), 6U);
  for (const dt::PushTrace& push : findings.pushes) {
    double x = 0, v = 0, t = 0;
    constexpr double h = 1e-6;
    for (; x < 5e-3; t += h) {
      const double rub = v > 0 ? desc.friction : std::min(desc.friction, t);
      v += h * (t - desc.damping * v - rub) / desc.handle_mass;
      x += h * v;
    }
    EXPECT_NEAR(push.time.back(), t, 3 * kTick) << push.name;
    EXPECT_NEAR(push.commanded.back(), t, 3e-3) << push.name;
  }
}

// In every tick, whatever it asks: by what the device itself was told.
TEST(DeviceTestPush, NeverPushesHarderOrFasterThanItsBudget) {
  for (const double max_force : {8.0, 2.0}) {
    DeviceDesc desc = arm();
    desc.max_force = max_force;
    desc.friction = 10;  // holds it: a push grows to its largest
    Free device(desc);
    const dt::Findings findings = walk_alone(device);
    const double budget = std::min(0.2 * max_force, 1.0);
    double most = 0, step = 0;
    Wrench last;
    for (const Wrench& F : device.told) {
      most = std::max(most, F.force.norm());
      step = std::max(step, (F.force - last.force).norm());
      EXPECT_TRUE(F.torque.isZero(0));
      last = F;
    }
    EXPECT_NEAR(most, budget, 1e-3 * budget);
    EXPECT_LE(most, budget * (1 + 1e-12));
    EXPECT_LE(step, budget * kTick / 5e-3 * (1 + 1e-9));  // the slew limit: all of it within 5 ms
    EXPECT_TRUE(last.force.isZero(0)) << "it does not end at rest";
    for (const char* const name : kPushes) {
      EXPECT_EQ(part(findings, name).outcome, Outcome::odd);
      EXPECT_NE(part(findings, name).says.find("did not give way"), std::string::npos);
    }
  }
}

TEST(DeviceTestPush, MotorsTheWrongWayRoundAreNamed) {
  Free device(arm(), Vec3(1, -1, 1).asDiagonal());
  const dt::Findings findings = walk_alone(device);
  EXPECT_EQ(part(findings, kPushes[0]).outcome, Outcome::good);
  EXPECT_EQ(part(findings, kPushes[1]).outcome, Outcome::bad);
  EXPECT_NE(part(findings, kPushes[1]).says.find("against"), std::string::npos);
  EXPECT_EQ(dt::outcome_of(findings), Outcome::bad);
}

TEST(DeviceTestPush, SwappedMotorsAreNamed) {
  Mat3 swapped;
  swapped << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  Free device(arm(), swapped);
  const dt::Findings findings = walk_alone(device);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(part(findings, kPushes[axis]).outcome, Outcome::bad);
    EXPECT_NE(part(findings, kPushes[axis]).says.find("across"), std::string::npos);
  }
  EXPECT_EQ(part(findings, kPushes[2]).outcome, Outcome::good);
}

TEST(DeviceTestPush, ADeviceThatTwistsIsTwistedToo) {
  DeviceDesc desc = arm();
  desc.renders_torque = true;
  desc.max_torque = 0.1;
  Free device(desc);
  const dt::Findings findings = walk_alone(device);
  for (const char* const name : {"twist, tilting", "twist, turning", "twist, rolling"}) {
    EXPECT_EQ(part(findings, name).outcome, Outcome::good) << part(findings, name).says;
    EXPECT_GT(measure(part(findings, name), "moved there"), 95);  // mrad
  }
  for (const Wrench& F : device.told) EXPECT_LE(F.torque.norm(), 0.02 * (1 + 1e-12));
}

// In the middle of a push; by what the device was told.
TEST(DeviceTestPush, WhateverComesTheForceFallsAndTheTestEndsThere) {
  const std::function<void(DeviceSample&)> spoils[] = {
      [](DeviceSample& s) { s.connected = false; }, [](DeviceSample& s) { s.age = 0.05; },
      [](DeviceSample& s) { s.X_DH.p.x() = NAN; }, [](DeviceSample& s) { s.age = NAN; }};
  for (const auto& spoil : spoils) {
    Played device(arm());
    int pushed_at = -1;
    device.on_read = [&](Played& d) {
      if (pushed_at < 0 && !d.told.empty() && d.told.back().F_H_D.force.norm() > 0.4) pushed_at = d.ticks;
      if (pushed_at >= 0) spoil(d.sample);
    };
    dt::TestBench bench = bench_of(device);
    dt::NobodyThere nobody;
    const dt::Findings findings = dt::walk(bench, nobody);
    ASSERT_GE(pushed_at, 0);
    EXPECT_TRUE(bench.stopped());
    EXPECT_EQ(part(findings, "the end").outcome, Outcome::bad);
    EXPECT_FALSE(bench.why_stopped().empty());
    EXPECT_EQ(part(findings, kPushes[0]).outcome, Outcome::unknown);
    for (std::size_t i = static_cast<std::size_t>(pushed_at) + 2; i < device.told.size(); ++i)
      EXPECT_TRUE(device.told[i].F_H_D.force.isZero(0)) << i - static_cast<std::size_t>(pushed_at);
    EXPECT_LT(device.told.size(), static_cast<std::size_t>(pushed_at) + 100) << "it went on";
  }
}

TEST(DeviceTestPush, WhoWantsItToEndIsHeardInTheMiddleOfAPush) {
  Played device(arm());
  bool end = false;
  device.on_read = [&](Played& d) {
    end = end || (!d.told.empty() && d.told.back().F_H_D.force.norm() > 0.4);
  };
  dt::TestBench bench = bench_of(device, [&] { return end; });
  dt::NobodyThere nobody;
  const dt::Findings findings = dt::walk(bench, nobody);
  EXPECT_FALSE(bench.stopped());
  EXPECT_EQ(part(findings, "the end").outcome, Outcome::unknown);
  EXPECT_TRUE(device.told.back().F_H_D.force.isZero(0));
}

}  // namespace
}  // namespace fulcrum::test
