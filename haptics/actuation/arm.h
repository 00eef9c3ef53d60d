#pragma once
// Device kinematics: how motor efforts add up to a wrench on the handle.

#include <span>
#include <string>

#include "haptics/device/device.h"

namespace fulcrum {

// Rows of J^T: effort of each motor per unit wrench (force; torque) on the handle, (motors x 6). For a linear
// motor the unit is 1, for a revolute one m.
using ActuationMatrix = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor, kMaxMotors, 6>;

class DeviceArm {
public:
  explicit DeviceArm(const DeviceDesc& desc);

  int motors() const { return motors_; }
  double limit(int motor) const;                                     // N or N m
  static std::string motor_name(const DeviceDesc& desc, int motor);  // as in actuator/load/NAME

  // J^T at a handle pose. A serial arm: absolute joint angles, D's origin where both links are at right
  // angles.
  ActuationMatrix transposed_jacobian(const Pose& X_DH) const noexcept;

private:
  DeviceDesc desc_;
  int motors_;
};

// tau = J^T F, all scaled alike where one would pass its limit: the wrench gets smaller and keeps its
// direction.
struct Allocation {
  DeviceCommand command;
  std::array<double, kMaxMotors> load{};  // fraction of each motor's limit
  double scale = 1;                       // of the wrench, below 1 where a motor would have passed its limit
  bool clamped() const { return scale < 1; }
};
Allocation allocate(const DeviceArm& arm, const Pose& X_DH, const Wrench& F_H_D) noexcept;

}  // namespace fulcrum
