#include "haptics/actuation/arm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum {
namespace {

DeviceDesc phantom() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::serial_arm;
  return desc;
}

// Forward kinematics as arm.cpp states them, about D's origin.
Vec3 handle(const DeviceDesc& desc, double yaw, double shoulder, double elbow) {
  const double l = desc.link_length, r = l * std::cos(shoulder) + l * std::sin(elbow);
  return Vec3(r * std::sin(yaw), l * std::sin(shoulder) - l * std::cos(elbow), r * std::cos(yaw)) -
         Vec3(0, -l, l);
}

TEST(DeviceArm, SerialArmJacobianIsTheDerivativeOfItsKinematics) {
  const DeviceDesc desc = phantom();
  const DeviceArm arm(desc);
  const double h = 1e-6;
  for (double yaw : {-0.5, 0.0, 0.4}) {
    for (double shoulder : {-0.3, 0.2, 0.5}) {
      for (double elbow : {-0.2, 0.0, 0.3}) {
        const ActuationMatrix JT =
            arm.transposed_jacobian({Quat::Identity(), handle(desc, yaw, shoulder, elbow)});
        const Vec3 by_yaw =
            (handle(desc, yaw + h, shoulder, elbow) - handle(desc, yaw - h, shoulder, elbow)) / (2 * h);
        const Vec3 by_shoulder =
            (handle(desc, yaw, shoulder + h, elbow) - handle(desc, yaw, shoulder - h, elbow)) / (2 * h);
        const Vec3 by_elbow =
            (handle(desc, yaw, shoulder, elbow + h) - handle(desc, yaw, shoulder, elbow - h)) / (2 * h);
        EXPECT_NEAR((JT.block<1, 3>(0, 0).transpose() - by_yaw).norm(), 0, 1e-8);
        EXPECT_NEAR((JT.block<1, 3>(1, 0).transpose() - by_shoulder).norm(), 0, 1e-8);
        EXPECT_NEAR((JT.block<1, 3>(2, 0).transpose() - by_elbow).norm(), 0, 1e-8);
      }
    }
  }
}

TEST(DeviceArm, SaturationKeepsTheDirection) {
  const DeviceArm arm(phantom());
  const Wrench wanted{Vec3(30, -20, 10), Vec3::Zero()};
  const Allocation allocation = allocate(arm, Pose{}, wanted);
  EXPECT_TRUE(allocation.clamped());
  double largest = 0;
  for (double load : allocation.load) largest = std::max(largest, std::abs(load));
  EXPECT_NEAR(largest, 1.0, 1e-12);
  EXPECT_NEAR(allocation.command.F_H_D.force.normalized().dot(wanted.force.normalized()), 1.0, 1e-12);
}

TEST(DeviceArm, SingularPosesGiveFiniteEfforts) {
  const DeviceArm arm(phantom());
  for (const Vec3& p : {Vec3(0, 0.14, -0.14), Vec3(0, 1, 5), Vec3(0, 0.14, 0.14)}) {
    const Allocation allocation = allocate(arm, {Quat::Identity(), p}, {Vec3(1, 1, 1), Vec3::Zero()});
    EXPECT_TRUE(allocation.command.F_H_D.is_finite());
    for (double effort : allocation.command.effort) EXPECT_TRUE(std::isfinite(effort));
  }
}

TEST(DeviceArm, AMouseHasNoMotors) {
  DeviceDesc desc;
  desc.renders_force = false;
  EXPECT_EQ(DeviceArm(desc).motors(), 0);
  EXPECT_EQ(allocate(DeviceArm(desc), Pose{}, {Vec3(1, 0, 0), Vec3::Zero()}).command.F_H_D.force.norm(), 0);
}

}  // namespace
}  // namespace fulcrum
