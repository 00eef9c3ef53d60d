#pragma once
// Devices of one arm: as content/devices has them.

#include "haptics/device/device.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::arms {

// (3) each from -1 to 1.
inline Vec3 random_vector(SplitMix& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return 2 * Vec3(x, y, z) - Vec3::Ones();
}

inline JointDesc joint(const char* name, const Vec3& axis_K, const Vec3& point_K, double limit, double stop) {
  return {
      .name = name, .axis_K = axis_K, .point_K = point_K, .low = -stop, .high = stop, .max_torque = limit};
}

// Yaw, shoulder, elbow, the last driven from the base; links level and hanging at home.
inline ArmDesc desktop(double first, double second, double limit) {
  ArmDesc arm{.name = "arm",
              .joints = {joint("yaw", Vec3::UnitY(), Vec3::Zero(), limit, 1.4),
                         joint("shoulder", -Vec3::UnitX(), Vec3::Zero(), limit, 1.6),
                         joint("elbow", -Vec3::UnitX(), {0, 0, first}, limit, 1.5)},
              .end_K = {0, -second, first}};
  arm.joints[2].through_parallelogram = true;
  return arm;
}

inline DeviceDesc phantom() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.mechanism.arms = {desktop(0.14, 0.14, 1.2)};
  return desc;
}

inline DeviceDesc serial6() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.renders_torque = true;
  desc.max_force = 8.5;
  desc.max_torque = 0.188;
  ArmDesc arm = desktop(0.215, 0.17, 1.83);
  arm.joints[2].max_torque = 1.45;
  arm.joints.push_back(joint("gimbal_yaw", Vec3::UnitY(), arm.end_K, 0.188, 2.6));
  arm.joints.push_back(joint("gimbal_pitch", Vec3::UnitX(), arm.end_K, 0.188, 1.3));
  arm.joints.push_back(joint("gimbal_roll", Vec3::UnitZ(), arm.end_K, 0.048, 3.1));
  desc.mechanism.arms = {std::move(arm)};
  return desc;
}

inline DeviceDesc freedom6s() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.renders_torque = true;
  desc.max_force = 2.5;
  desc.max_torque = 0.45;
  ArmDesc arm{.name = "arm",
              .joints = {joint("base", Vec3::UnitY(), {-0.2, 0, 0}, 0.5, 1.2),
                         joint("shoulder", Vec3::UnitZ(), {-0.2, 0.2, 0}, 0.5, 1.2),
                         joint("elbow", Vec3::UnitZ(), {0, 0.2, 0}, 0.5, 1.4),
                         joint("yaw", Vec3::UnitY(), Vec3::Zero(), 0.45, 1.5),
                         joint("pitch", Vec3::UnitZ(), Vec3::Zero(), 0.45, 1.2),
                         joint("roll", Vec3::UnitX(), Vec3::Zero(), 0.1, 3.1)},
              .end_K = Vec3::Zero()};
  arm.joints[1].low = -0.9;
  arm.joints[2].through_parallelogram = true;
  desc.mechanism.arms = {std::move(arm)};
  return desc;
}

}  // namespace fulcrum::arms
