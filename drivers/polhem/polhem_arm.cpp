#include "drivers/polhem/polhem_arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/math/rotation.h"

namespace fulcrum::polhem {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kCountsPerTurn = 2000;  // of a motor
constexpr double kGimbalCountsPerTurn = 1024;
constexpr std::array<double, 3> kGear{18, 10, 10};  // turns of the motor for one of its link
constexpr double kTorqueConstant = 0.0538;          // N m/A
// Motors turn against the links' angles as the interface counts them; so do two of the gimbal's encoders.
constexpr double kMotorSense = -1;
constexpr std::array<double, 3> kGimbalSense{-1, 1, -1};

Pose frame_of(const ArmDesc& arm, const Quat& q_DK) {
  const JointChain turned(arm, {q_DK, Vec3::Zero()});
  return {q_DK, -turned.place(turned.home()).X_DE.p};
}

// The links' angles as the interface counts them, rad: yaw, upper link from upright, lower link from hanging.
std::array<double, 3> links_at(const std::array<int, 6>& counts) {
  std::array<double, 3> links{};
  for (std::size_t i = 0; i < links.size(); ++i)
    links[i] = kMotorSense * kTurn * counts[i] / (kCountsPerTurn * kGear[i]);
  return links;
}

Quat about(const Vec3& axis, double angle) {
  return quaternion_exp(angle * axis);
}

}  // namespace

PolhemArm::PolhemArm(const DeviceDesc& desc)
    : q_DK_(desc.mechanism.q_DK),
      chain_(desc.mechanism.arms.front(), frame_of(desc.mechanism.arms.front(), q_DK_)) {
  const JointAngles home = chain_.home();
  q_KH_home_ =
      about(Vec3::UnitZ(), home[0]) * about(Vec3::UnitY(), std::numbers::pi / 2 - (home[1] + home[2]));
}

// The table's joints turn about -y: the upper link's leans outward by less than 0, and the lower link's
// counts from the upper one.
JointAngles PolhemArm::joints_at(const std::array<int, 6>& counts) noexcept {
  const auto [yaw, upper, lower] = links_at(counts);
  return {yaw, -upper, lower + upper};
}

// The gimbal hangs on the lower link: roll, pitch and roll of the stylus follow it.
Quat PolhemArm::turn_K(const std::array<int, 6>& counts) noexcept {
  const auto [yaw, upper, lower] = links_at(counts);
  const auto gimbal = [&](std::size_t joint) {
    return kGimbalSense[joint] * kTurn * counts[5 - joint] / kGimbalCountsPerTurn;
  };
  return about(Vec3::UnitZ(), yaw) * about(Vec3::UnitY(), std::numbers::pi / 2 - lower) *
         about(Vec3::UnitX(), gimbal(0)) * about(Vec3::UnitY(), gimbal(1)) * about(Vec3::UnitX(), gimbal(2));
}

Pose PolhemArm::X_DH(const std::array<int, 6>& counts) const noexcept {
  const Quat q_DH = q_DK_ * turn_K(counts) * q_KH_home_.conjugate() * q_DK_.conjugate();
  return {q_DH.normalized(), chain_.place(joints_at(counts)).X_DE.p};
}

// The table's motors: yaw and lower link as the interface counts them, the upper link the other way.
std::array<int, 3> PolhemArm::currents(const DeviceCommand& command) const noexcept {
  const std::array<double, 3> torque{command.effort[0], -command.effort[1], command.effort[2]};
  std::array<int, 3> mA{};
  for (std::size_t i = 0; i < mA.size(); ++i) {
    const double wanted = 1e3 * kMotorSense * torque[i] / (kGear[i] * kTorqueConstant);
    if (std::isnan(wanted)) return {};
    mA[i] = static_cast<int>(std::lround(std::clamp<double>(wanted, -kMostCurrent_mA, kMostCurrent_mA)));
  }
  return mA;
}

}  // namespace fulcrum::polhem
