#pragma once
// Which efforts make a wrench: the smallest of them (the pseudoinverse's), and what can be added to it
// without the handle feeling anything, where there are more motors than a wrench has rows.
//
// A motor whose limit is 0 takes no part. Where the others cannot make every wrench, force goes before
// torque: it is made exactly where it can be, and of the torque what is nearest.

#include "haptics/actuation/actuators.h"

namespace fulcrum {

class MotorSpace {
public:
  // What the efforts of a device with eight motors and six rows have to spare.
  static constexpr int kMaxSpare = 2;
  using Spare = Eigen::Matrix<double, kMaxMotors, kMaxSpare>;

  explicit MotorSpace(const Actuators& actuators);

  // The matrix of this pose. lever m: what counts a torque beside a force.
  void factorise(const WrenchMatrix& wrenches, double lever) noexcept;

  // The smallest effort that makes F_H_D.
  Effort smallest(const Wrench& F_H_D) const noexcept;
  // The wrench that an effort makes. Where the motors can set force alone it has no torque.
  Wrench wrench(const Effort& effort) const noexcept;
  // Columns of efforts that are not felt; zero where there is nothing to spare.
  const Spare& spare() const { return spare_; }
  bool complete() const { return complete_; }  // every wrench of the device's rows can be made

private:
  template <int kRows>
  void factorise_rows(const WrenchMatrix& wrenches, double lever) noexcept;

  int rows_;
  Effort live_;                                   // 1 for a motor that has a limit, else 0
  WrenchMatrix wrenches_;                         // rows that the motors cannot set are zero
  Eigen::Matrix<double, kMaxMotors, 6> inverse_;  // columns that the motors cannot set are zero
  Spare spare_;
  bool complete_ = false;
};

}  // namespace fulcrum
