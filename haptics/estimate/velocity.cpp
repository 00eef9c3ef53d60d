// adaptive_window: F. Janabi-Sharifi, V. Hayward, C.-S. J. Chen, "Discrete-time adaptive windowing for
// velocity estimation", IEEE Trans. Control Systems Technology 8(6), 2000: the longest window over which the
// motion is a straight line to within the noise (end-fit).

#include "haptics/estimate/velocity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {

VelocityEstimator::VelocityEstimator(const VelocityEstimatorDesc& desc, double tick_s)
    : desc_(desc), tick_s_(tick_s), keep_(math::exp(-2.0 * std::numbers::pi * desc.cutoff_Hz * tick_s)) {
  const bool long_path = desc.kind == VelocityEstimatorKind::adaptive_window;
  path_.assign(long_path ? static_cast<std::size_t>(desc.window) + 1 : 2, Vec6::Zero());
}

void VelocityEstimator::reset(const Pose& X_WH) noexcept {
  last_ = X_WH;
  started_ = true;
  filtered_.setZero();
  head_ = 0;
  filled_ = 0;
  path_[0].setZero();
}

Twist VelocityEstimator::update(const Pose& X_WH) noexcept {
  Vec6 moved = Vec6::Zero();
  if (started_) moved << X_WH.p - last_.p, rotation_vector(X_WH.q * last_.q.conjugate());
  return update(X_WH, moved);
}

Twist VelocityEstimator::update(const Pose& X_WH, const Vec6& moved) noexcept {
  if (!started_) {
    reset(X_WH);
    return {};
  }
  last_ = X_WH;
  const Vec6 now = path_[head_] + moved;
  head_ = (head_ + 1) % path_.size();
  path_[head_] = now;
  filled_ = std::min<int>(filled_ + 1, static_cast<int>(path_.size()) - 1);

  Vec6 velocity = Vec6::Zero();
  switch (desc_.kind) {
    case VelocityEstimatorKind::difference:
      velocity = difference();
      break;
    case VelocityEstimatorKind::low_pass:
      filtered_ = keep_ * filtered_ + (1.0 - keep_) * difference();
      velocity = filtered_;
      break;
    case VelocityEstimatorKind::adaptive_window:
      velocity = adaptive();
      break;
  }
  return {velocity.head<3>(), velocity.tail<3>()};
}

Vec6 VelocityEstimator::difference() const noexcept {
  const std::size_t before = (head_ + path_.size() - 1) % path_.size();
  return (path_[head_] - path_[before]) / tick_s_;
}

Vec6 VelocityEstimator::adaptive() const noexcept {
  const std::size_t size = path_.size();
  Vec6 velocity = Vec6::Zero();
  for (int axis = 0; axis < 6; ++axis) {
    const double noise = axis < 3 ? desc_.noise : desc_.noise_rad;
    const double newest = path_[head_][axis];
    for (int n = 1; n <= filled_; ++n) {
      const double slope = (newest - path_[(head_ + size - static_cast<std::size_t>(n)) % size][axis]) / n;
      bool straight = true;
      for (int i = 1; i < n && straight; ++i) {
        const double seen = path_[(head_ + size - static_cast<std::size_t>(i)) % size][axis];
        straight = std::abs(seen - (newest - slope * i)) <= noise;
      }
      if (!straight) break;
      velocity[axis] = slope / tick_s_;
    }
  }
  return velocity;
}

double VelocityEstimator::delay() const {
  switch (desc_.kind) {
    case VelocityEstimatorKind::difference:
      return 0.5 * tick_s_;
    case VelocityEstimatorKind::low_pass:
      return tick_s_ * (0.5 + keep_ / (1.0 - keep_));
    case VelocityEstimatorKind::adaptive_window:
      return 0.5 * tick_s_ * desc_.window;
  }
  return 0;
}

}  // namespace fulcrum
