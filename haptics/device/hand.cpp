#include "haptics/device/hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum {

HandPath::HandPath(std::vector<Waypoint> waypoints) : waypoints_(std::move(waypoints)) {
  double end = waypoints_.front().dwell;  // nowhere to travel from
  end_.push_back(end);
  for (std::size_t i = 1; i < waypoints_.size(); ++i)
    end_.push_back(end += waypoints_[i].travel + waypoints_[i].dwell);
  twists_.resize(waypoints_.size());
  for (std::size_t i = 1; i + 1 < waypoints_.size(); ++i) {
    if (!passes(i)) continue;
    const Pose &before = waypoints_[i - 1].X_WT, &after = waypoints_[i + 1].X_WT;
    const double time = waypoints_[i].travel + waypoints_[i + 1].travel;
    twists_[i] = {(after.p - before.p) / time, rotation_vector(after.q * before.q.conjugate()) / time};
  }
  Grip grip;
  for (const Waypoint& waypoint : waypoints_) {
    grip = {waypoint.hold.value_or(grip.hold), waypoint.press.value_or(grip.press)};
    grips_.push_back(grip);
    slides_ = slides_ || waypoint.hold;
  }
}

bool HandPath::passes(std::size_t i) const {
  return i > 0 && i + 1 < waypoints_.size() && waypoints_[i].through && waypoints_[i].dwell <= 0;
}

Grip HandPath::grip(double time) const {
  const auto next = static_cast<std::size_t>(std::upper_bound(end_.begin(), end_.end(), time) - end_.begin());
  if (next == 0) return grips_.front();
  if (next == grips_.size()) return grips_.back();
  const double s = std::min(1.0, (time - end_[next - 1]) / waypoints_[next].travel);
  return {std::lerp(grips_[next - 1].hold, grips_[next].hold, s),
          std::lerp(grips_[next - 1].press, grips_[next].press, s)};
}

std::uint32_t HandPath::buttons(double time) const {
  const auto at = static_cast<std::size_t>(std::upper_bound(end_.begin(), end_.end(), time) - end_.begin());
  if (at == end_.size() || !waypoints_[at].stop) return 0;
  const double rested = time - (end_[at] - waypoints_[at].dwell);
  if (rested < 0) return 0;
  return rested < *waypoints_[at].stop ? kHandStopButton : kHandGoButton;
}

Pose HandPath::at(double time) const {
  const auto next = static_cast<std::size_t>(std::upper_bound(end_.begin(), end_.end(), time) - end_.begin());
  if (next == 0) return waypoints_.front().X_WT;
  if (next == waypoints_.size()) return waypoints_.back().X_WT;
  const Pose& from = waypoints_[next - 1].X_WT;
  const Pose& to = waypoints_[next].X_WT;
  const double s = std::min(1.0, (time - end_[next - 1]) / waypoints_[next].travel);
  const double along = s * s * s * (10 + s * (6 * s - 15));  // minimum jerk
  const Vec3 straight = from.p + along * (to.p - from.p);
  if (!passes(next - 1) && !passes(next)) return {slerp(from.q, to.q, along), straight};
  // The polynomials of fifth degree that begin and end at 0, without acceleration, and begin or end at the
  // pace 1 (quintic Hermite basis).
  const double travel = waypoints_[next].travel;
  const double setting_out = travel * s * (1 - s * s * (6 + s * (3 * s - 8)));
  const double arriving = travel * s * s * s * (s * (7 - 3 * s) - 4);
  const Twist &V0 = twists_[next - 1], &V1 = twists_[next];
  const Vec3 whole = rotation_vector(to.q * from.q.conjugate());
  // The rate of the rotation vector at which the angular velocity at the end is V1's: the inverse of the left
  // Jacobian of SO(3), to third order in the turn.
  const Vec3 rate = V1.w - 0.5 * whole.cross(V1.w) + whole.cross(whole.cross(V1.w)) / 12;
  const Vec3 turn = along * whole + setting_out * V0.w + arriving * rate;
  return {(quaternion_exp(turn) * from.q).normalized(), straight + setting_out * V0.v + arriving * V1.v};
}

Tremor::Tremor(const HandDesc& desc) {
  SplitMix random(desc.seed);
  const double per_tone = std::sqrt(2.0 / kTones);
  for (std::size_t axis = 0; axis < 6; ++axis) {
    for (Tone& tone : tones_[axis]) {
      tone.w = 2 * std::numbers::pi * std::lerp(desc.tremor_low_Hz, desc.tremor_high_Hz, random.uniform());
      tone.phase = 2 * std::numbers::pi * random.uniform();
      tone.amplitude = per_tone * (axis < 3 ? desc.tremor : desc.tremor_rad);
    }
  }
}

Vec6 Tremor::at(double time) const {
  Vec6 sum = Vec6::Zero();
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (const Tone& tone : tones_[axis])
      sum[static_cast<Eigen::Index>(axis)] += tone.amplitude * math::sin(tone.w * time + tone.phase);
  return sum;
}

}  // namespace fulcrum
