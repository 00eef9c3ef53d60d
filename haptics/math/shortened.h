#pragma once
// Clamping that keeps direction.

#include "haptics/math/linear.h"

namespace fulcrum {

// v, no longer than limit.
inline Vec3 shortened(const Vec3& v, double limit) {
  const double length = v.norm();
  return length > limit ? Vec3(v * (limit / length)) : v;
}

}  // namespace fulcrum
