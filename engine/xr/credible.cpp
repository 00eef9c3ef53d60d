#include "engine/xr/credible.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/xr/pose.h"
#include "haptics/math/rotation.h"

namespace fulcrum::xr {
namespace {

// s: cameras may see a hand no more often, and a runtime may repeat what they saw.
constexpr double kSeldomSeen = 1.0 / 30;

constexpr double kRightAngle = 0.5 * std::numbers::pi;

}  // namespace

std::optional<Vec3> credible(const XrVector3f& p) {
  const Vec3 place(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
  // What is no number is not below the limit either.
  if (!(place.cwiseAbs().maxCoeff() <= kFarthest) || !place.allFinite()) return std::nullopt;
  return place;
}

std::optional<Pose> credible(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  const double length = std::hypot(std::hypot(static_cast<double>(q.x), static_cast<double>(q.y)),
                                   std::hypot(static_cast<double>(q.z), static_cast<double>(q.w)));
  if (!(std::abs(length - 1) <= kTurnError) || !credible(pose.position)) return std::nullopt;
  return pose_of(pose);
}

bool is_credible(const XrFovf& fov) {
  const auto seen = [](float from, float to) {
    const auto a = static_cast<double>(from), b = static_cast<double>(to);
    // What is no number is not within the limit either.
    return std::abs(a) < kRightAngle && std::abs(b) < kRightAngle && b - a >= kNarrowestView;
  };
  return seen(fov.angleLeft, fov.angleRight) && seen(fov.angleDown, fov.angleUp);
}

std::optional<Pose> Sighting::follow(const std::optional<Pose>& X, XrTime time) {
  const std::optional<Pose> before = std::exchange(before_, X);
  const double since_picture = 1e-9 * static_cast<double>(time - std::exchange(picture_at_, time));
  const bool is_repeated = before && X && before->p == X->p && before->q.coeffs() == X->q.coeffs();
  if (is_repeated) return X;
  const double since_elsewhere = 1e-9 * static_cast<double>(time - std::exchange(here_at_, time));
  if (!before || !X) return X;
  // A pose that was repeated for longer than kSeldomSeen was seen anew meanwhile: the hand lay still, and
  // moved after the picture before.
  const double passed = std::min(since_elsewhere, std::max(since_picture, kSeldomSeen));
  const bool leaps =
      (X->p - before->p).norm() > kFastest * passed || angle_between(X->q, before->q) > kFastestTurn * passed;
  return leaps ? std::nullopt : X;
}

}  // namespace fulcrum::xr
