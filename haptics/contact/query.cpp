#include "haptics/contact/query.h"

#include <algorithm>
#include <utility>

namespace fulcrum {

ContactQuery::ContactQuery(std::shared_ptr<const Pointshell> shell_T,
                           std::shared_ptr<const DistanceField> field_W)
    : shell_(std::move(shell_T)), field_(std::move(field_W)) {
  distance_.assign(shell_->size(), 0.0);
  radius_.reserve(shell_->size());
  for (const Vec3& p_T : shell_->positions) radius_.push_back(p_T.norm());
}

ContactQuery::Outcome ContactQuery::run(const Pose& X_WT, ContactSet& set, double margin) noexcept {
  set.clear();
  // Far from everything: the whole tool is farther off than it reaches.
  const double clear = field_->distance(X_WT.p) - shell_->max_radius_m - field_->error_bound_m();
  if (clear > margin) {
    std::fill(distance_.begin(), distance_.end(), clear);
    nearest_ = clear;
    return {};
  }
  Outcome outcome;
  const Mat3 R_WT = X_WT.q.toRotationMatrix();
  nearest_ = kFarOutside_m;
  for (std::size_t i = 0; i < shell_->size(); ++i) {
    const Vec3 p_W = R_WT * shell_->positions[i] + X_WT.p;
    const double distance = field_->distance(p_W);
    distance_[i] = distance;
    nearest_ = std::min(nearest_, distance);
    if (distance < margin) {
      const FieldSample sample = field_->sample(p_W);
      outcome.in_band &= sample.in_band || distance > 0;
      outcome.complete &=
          set.add({static_cast<std::uint32_t>(i), p_W, sample.gradient, -distance, shell_->areas_m2[i]});
    }
  }
  return outcome;
}

double ContactQuery::safe_fraction(double travel, double turn, double allowance) const noexcept {
  const double error = field_->error_bound_m();
  if (travel + turn * shell_->max_radius_m <= std::max(nearest_ - error, 0.0) + allowance) return 1.0;
  double fraction = 1.0;
  for (std::size_t i = 0; i < distance_.size(); ++i) {
    const double reach = travel + turn * radius_[i];
    const double room = std::max(distance_[i] - error, 0.0) + allowance;
    if (reach > room) fraction = std::min(fraction, room / reach);
  }
  return fraction;
}

}  // namespace fulcrum
