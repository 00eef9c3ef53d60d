#include "haptics/safety/transient_budget.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/clamp_norm.h"

namespace fulcrum {

TransientBudget::TransientBudget(const TransientFigures& figures, const DeviceDesc& device, double tick_s)
    : figures_(figures),
      tick_s_(tick_s),
      peak_(device.renders_force ? figures.peak * device.max_force : 0.0),
      peak_torque_(device.renders_torque ? figures.peak * device.max_torque : 0.0),
      spent_(static_cast<std::size_t>(std::ceil(kWindow / tick_s))),
      block_(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(spent_.size()))))) {
  blocks_.resize((spent_.size() + block_ - 1) / block_);
}

TransientBudget::Spent& TransientBudget::Spent::operator+=(const Spent& other) noexcept {
  impulse += other.impulse;
  length += other.length;
  turn_length += other.turn_length;
  by_force += other.by_force;
  by_torque += other.by_torque;
  return *this;
}

// Added up anew, since running sums would gather rounding; by blocks, since a window of 10 kHz holds a
// thousand ticks.
TransientBudget::Spent TransientBudget::window() noexcept {
  const std::size_t block = at_ / block_, first = block * block_;
  blocks_[block] = {};
  for (std::size_t i = first; i < std::min(first + block_, spent_.size()); ++i) blocks_[block] += spent_[i];
  Spent sum;
  for (const Spent& each : blocks_) sum += each;
  return sum;
}

Wrench TransientBudget::allow(const Wrench& wanted, const Vec6& moved) noexcept {
  quiet_ = last_.is_zero() ? quiet_ + 1 : 0;
  if (quiet_ > spent_.size() && wanted.is_zero()) return {};
  const double by_force = last_.force.dot(moved.head<3>()), by_torque = last_.torque.dot(moved.tail<3>());
  force_energy_ += by_force;
  torque_energy_ += by_torque;
  spent_[at_] = {last_ * tick_s_, tick_s_ * last_.force.norm(), tick_s_ * last_.torque.norm(), by_force,
                 by_torque};
  const Spent sum = window();
  at_ = at_ + 1 == spent_.size() ? 0 : at_ + 1;

  const Wrench F{clamp_norm(wanted.force, peak_), clamp_norm(wanted.torque, peak_torque_)};
  const Wrench impulse = sum.impulse + F * tick_s_;
  const bool pushes =
      impulse.force.norm() > peak_ * figures_.push || impulse.torque.norm() > peak_torque_ * figures_.push;
  const bool lasts = sum.length + tick_s_ * F.force.norm() > peak_ * figures_.length ||
                     sum.turn_length + tick_s_ * F.torque.norm() > peak_torque_ * figures_.length;
  const bool gives = sum.by_force > figures_.energy || sum.by_torque > figures_.energy;
  return pushes || lasts || gives ? Wrench() : F;
}

void TransientBudget::commanded(const Wrench& F) noexcept {
  last_ = F;
}

}  // namespace fulcrum
