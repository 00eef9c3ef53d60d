#include "haptics/safety/transient_budget.h"

#include <cmath>

#include "haptics/math/shortened.h"

namespace fulcrum {

TransientBudget::TransientBudget(const DeviceDesc& device, double tick_s)
    : tick_s_(tick_s),
      peak_(kPeak * device.max_force),
      spent_(static_cast<std::size_t>(std::ceil(kWindow / tick_s))) {}

Vec3 TransientBudget::allow(const Vec3& wanted, const Vec3& moved) noexcept {
  quiet_ = last_.isZero(0) ? quiet_ + 1 : 0;
  if (quiet_ > spent_.size() && wanted.isZero(0)) return Vec3::Zero();
  const double given = last_.dot(moved);
  energy_ += given;
  spent_[at_] = {tick_s_ * last_, tick_s_ * last_.norm(), given};
  at_ = at_ + 1 == spent_.size() ? 0 : at_ + 1;
  Spent sum;  // anew each time: running sums would gather rounding, and a hundred additions are soon made
  for (const Spent& spent : spent_) {
    sum.impulse += spent.impulse;
    sum.length += spent.length;
    sum.energy += spent.energy;
  }

  const Vec3 force = shortened(wanted, peak_);
  const bool pushes = (sum.impulse + tick_s_ * force).norm() > peak_ * kPush;
  const bool lasts = sum.length + tick_s_ * force.norm() > peak_ * kLength;
  return pushes || lasts || sum.energy > kEnergy ? Vec3(Vec3::Zero()) : force;
}

void TransientBudget::commanded(const Vec3& force) noexcept {
  last_ = force;
}

}  // namespace fulcrum
