#include "engine/scenario/checkpoint_way.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum::scenario {
namespace {

// rad, of a small turn about a unit axis: the twist of q's swing and twist about it.
double turned_about(const Quat& q, const Vec3& axis) {
  const double half = math::atan2(q.vec().dot(axis), q.w());
  // q and -q are the same rotation; of the two answers that of less than half a turn.
  constexpr double kHalf = std::numbers::pi / 2;
  return 2 * (half > kHalf ? half - 2 * kHalf : half < -kHalf ? half + 2 * kHalf : half);
}

}  // namespace

CheckpointWay::CheckpointWay(const Checkpoint& checkpoint) : checkpoint_(checkpoint) {
  if (checkpoint_.follow.empty()) return;
  corners_.push_back(checkpoint_.position);
  for (const Vec3& corner : checkpoint_.follow) {
    length_ += (corner - corners_.back()).norm();
    corners_.push_back(corner);
  }
}

CheckpointWay::Nearest CheckpointWay::nearest(const Vec3& p_WC) const {
  const double to = along_ + 2 * checkpoint_.radius;
  Nearest best{along_, std::numeric_limits<double>::infinity()};
  double begins = 0;  // m, of the leg
  for (std::size_t i = 0; i + 1 < corners_.size() && begins <= to; ++i) {
    const Vec3 leg = corners_[i + 1] - corners_[i];
    const double length = leg.norm();
    // At the very end, sums of lengths may be a last digit more than the line has.
    const bool is_last = i + 2 == corners_.size();
    const double first = std::clamp(along_ - begins, 0.0, length), last = std::min(to - begins, length);
    if (length > 0 && (is_last || along_ <= begins + length)) {
      const Vec3 unit = leg / length;
      const double along = std::clamp((p_WC - corners_[i]).dot(unit), first, last);
      const double distance = (corners_[i] + along * unit - p_WC).norm();
      if (distance < best.distance) best = {begins + along, distance};
    }
    begins += length;
  }
  return best;
}

Vec3 CheckpointWay::at(double along) const {
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
    const Vec3 leg = corners_[i + 1] - corners_[i];
    const double length = leg.norm();
    if (along <= length && length > 0) return corners_[i] + along / length * leg;
    along -= length;
  }
  return corners_.back();
}

double CheckpointWay::depth_of(const Vec3& p_WC) const {
  return (p_WC - checkpoint_.position).dot(checkpoint_.insert->direction_W);
}

bool CheckpointWay::is_in_bore(const Vec3& p_WC) const {
  const double depth = depth_of(p_WC);
  const Vec3 axis = checkpoint_.position + depth * checkpoint_.insert->direction_W;
  return depth >= -checkpoint_.radius && (p_WC - axis).norm() <= checkpoint_.radius;
}

// Not a number is nowhere: each comparison fails.
bool CheckpointWay::holds(const Vec3& p_WC) const {
  const bool at_place = (p_WC - checkpoint_.position).norm() <= checkpoint_.radius;
  if (checkpoint_.insert) return inside_ ? is_in_bore(p_WC) : at_place;
  if (corners_.empty() || along_ <= 0) return at_place;
  const double share = inside_ ? 1 : kBack;
  return nearest(p_WC).distance <= share * checkpoint_.radius;
}

bool CheckpointWay::see(const Vec3& p_WC) {
  const bool was_inside = inside_;
  inside_ = holds(p_WC);
  slipped_ = was_inside && !inside_ && !paused_ && is_way(checkpoint_) && !is_done() &&
             std::max(along_, depth_) > checkpoint_.radius;
  paused_ = false;
  if (checkpoint_.insert) depth_ = inside_ ? depth_of(p_WC) : 0;
  return inside_;
}

void CheckpointWay::go_on(const Vec3& p_WC, const Quat& q_WT) {
  if (!corners_.empty()) {
    const bool ends = along_ + 2 * checkpoint_.radius >= length_;
    if (ends && (p_WC - corners_.back()).norm() <= checkpoint_.radius)
      along_ = length_;
    else
      along_ = nearest(p_WC).along;
  }
  if (checkpoint_.turn && angle_ < checkpoint_.turn->angle) {
    if (q_WT_)
      angle_ = std::max(0.0, angle_ + turned_about(q_WT * q_WT_->conjugate(), checkpoint_.turn->axis_W));
    q_WT_ = q_WT;
  }
}

double CheckpointWay::done() const {
  double done = 1;
  if (!corners_.empty()) done = along_ / length_;
  if (checkpoint_.insert) done = std::clamp(depth_ / checkpoint_.insert->depth, 0.0, 1.0);
  if (checkpoint_.turn) done = std::min(done, angle_ / checkpoint_.turn->angle);
  return done;
}

bool CheckpointWay::is_too_deep() const {
  return checkpoint_.insert && depth_ > checkpoint_.insert->depth + checkpoint_.radius;
}

Vec3 CheckpointWay::place_W() const {
  if (checkpoint_.insert && inside_)
    return checkpoint_.position + checkpoint_.insert->depth * checkpoint_.insert->direction_W;
  if (!corners_.empty() && along_ > 0) return at(std::min(length_, along_ + 2 * checkpoint_.radius));
  return checkpoint_.position;
}

}  // namespace fulcrum::scenario
