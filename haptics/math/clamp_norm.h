#pragma once
// Clamping that keeps direction.

#include <algorithm>
#include <cmath>

#include "haptics/math/linear.h"

namespace fulcrum {

// v, no longer than limit.
inline Vec3 clamp_norm(const Vec3& v, double limit) {
  const double length = v.norm();
  return length > limit ? Vec3(v * (limit / length)) : v;
}

// Of a limit: what rounding may add to a vector that was clamped to it.
inline constexpr double kRoundedLength = 1e-12;

// v is no longer than limit, to rounding.
inline bool within_length(const Vec3& v, double limit) {
  return v.norm() <= limit * (1 + kRoundedLength);
}

// The largest part of v, 0 to 1, that may be added to `there` so that the sum is no longer than limit: none
// where `there` alone is longer.
inline double part_beside(const Vec3& there, const Vec3& v, double limit) {
  if (within_length(there + v, limit)) return 1;
  const double a = v.squaredNorm(), b = there.dot(v), c = there.squaredNorm() - limit * limit;
  if (c >= 0 || !(a > 0)) return 0;
  return std::clamp((1 - kRoundedLength) * (std::sqrt(b * b - a * c) - b) / a, 0.0, 1.0);
}

}  // namespace fulcrum
