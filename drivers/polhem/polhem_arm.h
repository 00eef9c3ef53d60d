#pragma once
// Counts of a Polhem's encoders to the pose of its handle, and torques at its joints to currents of its
// motors. Links and joints are the table's; gears, counts and constants of the motors are version 1's.

#include <array>

#include "drivers/polhem/polhem_reports.h"
#include "haptics/actuation/joint_chain.h"
#include "haptics/device/device.h"

namespace fulcrum::polhem {

// Of the rest pose, in which the board is told to calibrate: upper link up, lower one level, stylus straight.
inline constexpr std::array<int, 6> kRestCounts{0, 0, -5000, 0, 0, 0};
inline constexpr int kMostCurrent_mA = 2000;

class PolhemArm {
public:
  // desc: of one arm of three joints, the last one through a parallelogram.
  explicit PolhemArm(const DeviceDesc& desc);

  Pose X_DH(const std::array<int, 6>& counts) const noexcept;
  // mA, each within kMostCurrent_mA.
  std::array<int, 3> currents(const DeviceCommand& command) const noexcept;

private:
  static JointAngles joints_at(const std::array<int, 6>& counts) noexcept;
  static Quat turn_K(const std::array<int, 6>& counts) noexcept;  // of the stylus, from straight at rest

  Quat q_DK_;
  JointChain chain_;
  Quat q_KH_home_;
};

}  // namespace fulcrum::polhem
