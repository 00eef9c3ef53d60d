#include "haptics/geometry/normal_cone.h"

#include <algorithm>
#include <numbers>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kRoundOfAngle = 1e-9;  // rad
constexpr double kNoAxis = 1e-6;        // a mean of unit vectors shorter than this tells no direction

NormalCone everything() {
  return {Vec3::UnitX(), std::numbers::pi};
}

}  // namespace

NormalCone::NormalCone(const Vec3& axis, double angle)
    : axis_(axis),
      angle_(std::min(angle + kRoundOfAngle, std::numbers::pi)),
      cosine_(math::cos(angle_)),
      sine_(math::sin(angle_)) {}

NormalCone NormalCone::about(std::span<const Vec3> directions) {
  if (directions.empty()) return {};
  Vec3 sum = Vec3::Zero();
  for (const Vec3& direction : directions) sum += direction;
  if (sum.norm() < kNoAxis * static_cast<double>(directions.size())) return everything();
  const Vec3 axis = sum.normalized();
  double angle = 0;
  for (const Vec3& direction : directions) angle = std::max(angle, angle_between(axis, direction));
  return {axis, angle};
}

NormalCone NormalCone::about(const NormalCone& a, const NormalCone& b) {
  if (a.none()) return b;
  if (b.none()) return a;
  const double between = angle_between(a.axis_, b.axis_);
  if (between + b.angle_ <= a.angle_) return a;
  if (between + a.angle_ <= b.angle_) return b;
  const double angle = (a.angle_ + between + b.angle_) / 2;
  if (angle >= std::numbers::pi || (a.axis_ + b.axis_).norm() < kNoAxis) return everything();
  // From a's axis towards b's, so that both just lie in it.
  const Vec3 turn_axis = a.axis_.cross(b.axis_).normalized();
  return {(turn_by(angle - a.angle_, turn_axis) * a.axis_).normalized(), angle};
}

bool NormalCone::opposes(const Vec3& axis, const NormalCone& other, const NormalCone& slack) const noexcept {
  if (angle_ + other.angle_ + slack.angle_ >= std::numbers::pi) return true;
  const double cosine = cosine_ * other.cosine_ - sine_ * other.sine_,
               sine = sine_ * other.cosine_ + cosine_ * other.sine_;
  return -axis.dot(other.axis_) >= cosine * slack.cosine_ - sine * slack.sine_;
}

}  // namespace fulcrum
