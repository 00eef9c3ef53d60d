#include "engine/xr/pinch.h"

namespace fulcrum::xr {
namespace {

bool are_together(const Vec3& a, const Vec3& b, bool were) {
  return (a - b).norm() < (were ? kApart : kTogether);
}

}  // namespace

Hand Pinch::follow(const std::optional<HandJoints>& joints) {
  Hand hand;
  hand.is_known = joints.has_value();
  if (joints) {
    const bool held = holds_;
    const bool together = are_together(joints->p_LThumb, joints->p_LIndex, held || met_unseen_);
    met_unseen_ = together && (met_unseen_ || (!was_seen_ && !held));
    holds_ = together && !met_unseen_;
    // A thumb is at one finger at a time: the one that it came to first.
    stops_ = !together && are_together(joints->p_LThumb, joints->p_LLittle, stops_);
    if (!held || !holds_)
      p_PG_ = joints->X_LP.inverse() * (0.5 * (joints->p_LThumb + joints->p_LIndex)).eval();
    hand.X_LG = Pose{joints->X_LP.q, joints->X_LP * p_PG_};
  }
  was_seen_ = joints.has_value();
  hand.holds = holds_;
  hand.stops = stops_;
  return hand;
}

}  // namespace fulcrum::xr
