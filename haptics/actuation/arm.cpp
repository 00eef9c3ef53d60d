#include "haptics/actuation/arm.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

int count_motors(const DeviceDesc& desc) {
  if (!desc.renders_force) return 0;
  switch (desc.kinematics) {
    case Kinematics::none:
      return 0;
    case Kinematics::cartesian:
      return desc.renders_torque ? 6 : 3;
    case Kinematics::serial_arm:
      return 3;
  }
  return 0;
}

}  // namespace

DeviceArm::DeviceArm(const DeviceDesc& desc) : desc_(desc), motors_(count_motors(desc)) {}

double DeviceArm::limit(int motor) const {
  if (desc_.kinematics == Kinematics::serial_arm) return desc_.max_joint_torque;
  return motor < 3 ? desc_.max_force : desc_.max_torque;
}

std::string DeviceArm::motor_name(const DeviceDesc& desc, int motor) {
  static constexpr const char* axes[] = {"x", "y", "z", "roll_x", "roll_y", "roll_z"};
  static constexpr const char* joints[] = {"yaw", "shoulder", "elbow"};
  return desc.kinematics == Kinematics::serial_arm ? joints[motor] : axes[motor];
}

// Forward kinematics from the yaw axis' foot, with l the length of both links:
//     p = ( r sin yaw,  l sin shoulder - l cos elbow,  r cos yaw ),   r = l cos shoulder + l sin elbow
ActuationMatrix DeviceArm::transposed_jacobian(const Pose& X_DH) const noexcept {
  ActuationMatrix JT = ActuationMatrix::Zero(motors_, 6);
  if (desc_.kinematics != Kinematics::serial_arm) {
    for (int motor = 0; motor < motors_; ++motor) JT(motor, motor) = 1.0;
    return JT;
  }
  if (motors_ == 0) return JT;
  const double l = desc_.link_length;
  const Vec3 p = X_DH.p + Vec3(0, -l, l);
  const double yaw = std::atan2(p.x(), p.z());
  const double r = std::hypot(p.x(), p.z());
  // The two links span (r, y); stretched out or folded up the arm is singular: stay just inside.
  const double span = std::clamp(std::hypot(r, p.y()), 0.01 * l, 1.999 * l);
  const double lift = std::atan2(p.y(), r);
  const double half = std::acos(0.5 * span / l);
  const double shoulder = lift + half;  // first link above the line to the handle
  const double second = lift - half;    // second link below it, from the horizontal
  const double s1 = std::sin(yaw), c1 = std::cos(yaw);
  JT.row(0) << r * c1, 0, -r * s1, 0, 0, 0;
  JT.row(1) << -l * std::sin(shoulder) * s1, l * std::cos(shoulder), -l * std::sin(shoulder) * c1, 0, 0, 0;
  JT.row(2) << -l * std::sin(second) * s1, l * std::cos(second), -l * std::sin(second) * c1, 0, 0, 0;
  return JT;
}

Allocation allocate(const DeviceArm& arm, const Pose& X_DH, const Wrench& F_H_D) noexcept {
  Allocation result;
  if (arm.motors() == 0) return result;
  const ActuationMatrix JT = arm.transposed_jacobian(X_DH);
  Vec6 F;
  F << F_H_D.force, F_H_D.torque;
  double worst = 0;
  for (int motor = 0; motor < arm.motors(); ++motor) {
    const auto slot = static_cast<std::size_t>(motor);
    result.command.effort[slot] = JT.row(motor).dot(F);
    worst = std::max(worst, std::abs(result.command.effort[slot]) / arm.limit(motor));
  }
  const double scale = worst > 1.0 ? 1.0 / worst : 1.0;
  result.scale = scale;
  result.command.F_H_D = F_H_D * scale;
  for (int motor = 0; motor < arm.motors(); ++motor) {
    const auto slot = static_cast<std::size_t>(motor);
    result.command.effort[slot] *= scale;
    result.load[slot] = result.command.effort[slot] / arm.limit(motor);
  }
  return result;
}

}  // namespace fulcrum
