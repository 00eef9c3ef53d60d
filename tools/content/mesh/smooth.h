#pragma once
// Functions that round what min, max and steps would leave sharp.

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum::content {

// I. Quilez, "smooth minimum" (iquilezles.org/articles/smin), the quadratic one: equal to max where they
// differ by more than k, and k/4 more where they are equal.
inline double smooth_max(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::max(a, b) + 0.25 * k * h * h;
}

inline double smooth_min(double a, double b, double k) {
  return -smooth_max(-a, -b, k);
}

// 0 at `from` and before, 1 at `to` and beyond; `from` may be the greater.
inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// 1 at 0, and 1/e at one width.
inline double bump(double x, double width) {
  const double t = x / width;
  return t * t > 30.0 ? 0.0 : math::exp(-t * t);
}

}  // namespace fulcrum::content
