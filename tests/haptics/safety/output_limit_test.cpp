#include "haptics/safety/output_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "haptics/math/split_mix.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

DeviceDesc six_axes() {
  DeviceDesc device;
  device.renders_torque = true;
  device.max_force = 5;
  device.max_torque = 0.2;
  return device;
}

// Motors as axes: the effort is the wrench.
OutputLimit::Part part(const Wrench& F_H_D) {
  OutputLimit::Part part{.F_H_D = F_H_D};
  part.effort << F_H_D.force, F_H_D.torque, 0, 0;
  return part;
}

Vec3 vector(SplitMix& random, double size) {
  return size * (2 * Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Ones());
}

// How far v is from what the last one could have fallen to, searched.
double grown(const Vec3& v, const Vec3& last) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 10000; ++i) least = std::min(least, (v - 1e-4 * i * last).norm());
  return least;
}

TEST(OutputLimit, WhatKeepsTheLimitsPassesToTheBit) {
  OutputLimit limit(six_axes(), kTick);
  OutputLimit::Output output{part({Vec3(0.7, -0.5, 0.3), Vec3(0.01, 0, 0.02)}),
                             part({Vec3(0.1, 0, 2), Vec3(0.1, 0, 0)})};
  const OutputLimit::Output before = output;
  EXPECT_EQ(limit.hold(output), 0u);
  EXPECT_EQ(output.continuous.F_H_D.force, before.continuous.F_H_D.force);
  EXPECT_EQ(output.transient.effort, before.transient.effort);
}

TEST(OutputLimit, WhateverComesForceTorqueMotorsAndSlewHold) {
  const DeviceDesc device = six_axes();
  OutputLimit limit(device, kTick);
  SplitMix random(3);
  Wrench last;
  int cut = 0;
  for (int i = 0; i < 5000; ++i) {
    OutputLimit::Output output{part({vector(random, 20), vector(random, 1)}),
                               part({vector(random, 20), vector(random, 1)})};
    if (i % 3 == 0)
      output.continuous = part({last.force + vector(random, 0.3), last.torque + vector(random, 0.01)});
    if (limit.hold(output) == kOutputLimited) ++cut;
    const Wrench sum = output.continuous.F_H_D + output.transient.F_H_D;
    EXPECT_LE(sum.force.norm(), device.max_force * (1 + 2e-9));
    EXPECT_LE(sum.torque.norm(), device.max_torque * (1 + 2e-9));
    const Effort effort = output.continuous.effort + output.transient.effort;
    EXPECT_LE(effort.head<3>().cwiseAbs().maxCoeff(), device.max_force * (1 + 2e-9));
    EXPECT_LE(effort.segment<3>(3).cwiseAbs().maxCoeff(), device.max_torque * (1 + 2e-9));
    EXPECT_NEAR((effort.head<3>() - sum.force).norm(), 0, 1e-12);  // they go on to belong together
    EXPECT_LE(grown(output.continuous.F_H_D.force, last.force), device.max_force * kTick / kSlewTime + 1e-3);
    EXPECT_LE(grown(output.continuous.F_H_D.torque, last.torque),
              device.max_torque * kTick / kSlewTime + 4e-5);
    last = output.continuous.F_H_D;
  }
  EXPECT_GT(cut, 3000);
}

TEST(OutputLimit, AMotorThatIsWeakerThanTheDeviceIsNotOverloaded) {
  DeviceDesc device = six_axes();
  device.max_force = 50;
  OutputLimit limit(device, kTick);
  OutputLimit::Output output{part({Vec3(1, 0, 0), Vec3::Zero()}), {}};
  output.continuous.effort[4] = 0.4;  // of 0.2
  EXPECT_EQ(limit.hold(output), kOutputLimited);
  EXPECT_NEAR(output.continuous.effort[4], 0.2, 1e-12);
  EXPECT_NEAR(output.continuous.F_H_D.force.x(), 0.5, 1e-12);
}

TEST(OutputLimit, ItMayFallAtOnceAndNeverTurnsOver) {
  OutputLimit limit(six_axes(), kTick);
  for (int i = 1; i <= 5; ++i) {
    OutputLimit::Output rising{part({Vec3(i, 0, 0), Vec3::Zero()}), {}};
    EXPECT_EQ(limit.hold(rising), 0u);
  }
  OutputLimit::Output lower{part({Vec3(1.5, 0, 0), Vec3::Zero()}), {}};
  EXPECT_EQ(limit.hold(lower), 0u);
  OutputLimit::Output turned{part({Vec3(-1.5, 0, 0), Vec3::Zero()}), {}};
  EXPECT_EQ(limit.hold(turned), kOutputLimited);
  EXPECT_NEAR(turned.continuous.F_H_D.force.x(), -1, 1e-8);
}

TEST(OutputLimit, WhatIsNoNumberBecomesNothing) {
  OutputLimit limit(six_axes(), kTick);
  OutputLimit::Output output{part({Vec3(1, 0, 0), Vec3::Zero()}), part({Vec3(0, 1, 0), Vec3::Zero()})};
  output.transient.effort[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(limit.hold(output), kOutputLimited | kNotFinite);
  EXPECT_TRUE(output.transient.F_H_D.is_zero());
  EXPECT_TRUE(output.transient.effort.isZero(0));
  EXPECT_EQ(output.continuous.F_H_D.force.x(), 1);
  output.continuous.F_H_D.torque.z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(limit.hold(output), kOutputLimited | kNotFinite);
  EXPECT_TRUE(output.continuous.F_H_D.is_zero());
}

TEST(OutputLimit, ADeviceWithoutAnAxisGetsNothingOnIt) {
  DeviceDesc device;
  device.max_torque = 1;  // of nothing: it renders no torque
  OutputLimit limit(device, kTick);
  OutputLimit::Output output;
  output.continuous.F_H_D.torque = Vec3(0.1, 0, 0);
  EXPECT_EQ(limit.hold(output), kOutputLimited);
  EXPECT_TRUE(output.continuous.F_H_D.is_zero());
}

}  // namespace
}  // namespace fulcrum::test
