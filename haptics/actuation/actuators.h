#pragma once
// The motors of a device: how many, how strong, and what wrench on the handle each makes where the handle is.

#include <optional>
#include <string>

#include "haptics/actuation/mechanism.h"

namespace fulcrum {

// (kMaxMotors) N or N m; 0 for motors that the device has not.
using Effort = Eigen::Matrix<double, kMaxMotors, 1>;

class Actuators {
public:
  explicit Actuators(const DeviceDesc& desc);

  static int count(const DeviceDesc& desc);
  static std::string name(const DeviceDesc& desc, int motor);  // as in actuator/load/NAME

  int count() const { return count_; }
  const Effort& limits() const { return limits_; }
  // Rows of a wrench that the motors can set: 3, force alone, or 6.
  int rows() const { return rows_; }

  // Where the handle is now.
  void follow(const Pose& X_DH) noexcept {
    if (mechanism_) mechanism_->follow(X_DH);
  }
  // G of F_H_D = G tau.
  const WrenchMatrix& wrenches() const { return mechanism_ ? mechanism_->wrenches() : axes_; }

private:
  int count_, rows_;
  Effort limits_ = Effort::Zero();
  std::optional<Mechanism> mechanism_;
  WrenchMatrix axes_ = WrenchMatrix::Zero();  // of a motor for each axis
};

}  // namespace fulcrum
