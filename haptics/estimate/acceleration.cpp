// Adaptation: the innovation's square over what the filter expects of it is 1 in the mean; process noise
// grows while it is more and shrinks while it is less. R. K. Mehra, "Approaches to adaptive filtering", IEEE
// Trans. Automatic Control 17(5), 1972 (covariance matching).

#include "haptics/estimate/acceleration.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kMaxSurprise = 9;  // three standard deviations: one outlier is not a change of mind
constexpr double kFastest = 0.1;    // of the process noise a tick, for each unit of surprise

}  // namespace

AccelerationEstimator::AccelerationEstimator(const AccelerationEstimatorDesc& desc, double tick_s)
    : desc_(desc),
      tick_s_(tick_s),
      model_(kalman_model(desc.jerk, desc.noise,
                          desc.kind == AccelerationEstimatorKind::adaptive ? desc.jerk_time : 0, tick_s)),
      steady_(steady_filter(model_, tick_s)) {}

void AccelerationEstimator::reset(const Vec3& p) noexcept {
  origin_ = p;
  state_.setZero();
  const Mat4 known = steady_.P - steady_.gain * steady_.P.row(0);
  for (Adaptation& axis : adaptation_) axis = {known, 1};
  started_ = p.allFinite();
}

Vec3 AccelerationEstimator::update(const Vec3& p) noexcept {
  if (!started_ || !p.allFinite()) {
    reset(p);
    return Vec3::Zero();
  }
  state_ = (model_.F * state_).eval();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double seen = (p[i] - origin_[i]) / desc_.noise, predicted = state_(0, i);
    const Vec4 gain = desc_.kind == AccelerationEstimatorKind::adaptive
                          ? adapted_gain(adaptation_[i], predicted, seen)
                          : steady_.gain;
    state_.col(i) += gain * (seen - predicted);
  }
  return acceleration();
}

Vec3 AccelerationEstimator::catch_up(const Vec3& p) noexcept {
  if (!started_ || !p.allFinite()) return update(p);
  state_.row(0) = (p - origin_).transpose() / desc_.noise;
  return acceleration();
}

Vec4 AccelerationEstimator::adapted_gain(Adaptation& axis, double predicted, double seen) const noexcept {
  const Mat4 P = model_.F * axis.P * model_.F.transpose() + axis.more * model_.Q;
  const double S = P(0, 0) + 1;
  const Vec4 gain = P.col(0) / S;
  Mat4 correct = Mat4::Identity();
  correct.col(0) -= gain;
  // Joseph's form: what is left is a covariance whatever the gain was rounded to.
  const Mat4 left = correct * P * correct.transpose() + gain * gain.transpose();
  axis.P = 0.5 * (left + left.transpose());
  const double innovation = seen - predicted;
  const double surprise = std::min(innovation * innovation / S, kMaxSurprise) - 1;
  const double most = desc_.range * desc_.range;
  axis.more *= 1 + std::min(tick_s_ / desc_.adapt_time, kFastest) * surprise;
  axis.more = std::clamp(axis.more, 1 / most, most);
  return gain;
}

Vec3 AccelerationEstimator::velocity() const {
  return state_.row(1).transpose() * (desc_.noise / tick_s_);
}

Vec3 AccelerationEstimator::acceleration() const {
  return state_.row(2).transpose() * (desc_.noise / (tick_s_ * tick_s_));
}

double AccelerationEstimator::noise() const {
  return steady_.a_rms * desc_.noise / (tick_s_ * tick_s_);
}

}  // namespace fulcrum
