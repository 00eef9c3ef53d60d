#include "tools/content/ear/cord.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double spacing = 0.9;  // mm, between knots of the finished cord

Vector4d packed(const Knot3& k) {
  return {k.p.x(), k.p.y(), k.p.z(), k.r};
}

Vector4d spline(const Vector4d& a, const Vector4d& b, const Vector4d& c, const Vector4d& d, double t) {
  const Vector4d slope_b = 0.5 * (c - a);
  const Vector4d slope_c = 0.5 * (d - b);
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * b + (t3 - 2 * t2 + t) * slope_b + (3 * t2 - 2 * t3) * c +
         (t3 - t2) * slope_c;
}

}  // namespace

Cord::Cord(const std::vector<Knot3>& knots) {
  const std::size_t last = knots.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const Vector4d b = packed(knots[i]);
    const Vector4d c = packed(knots[i + 1]);
    const Vector4d a = i > 0 ? packed(knots[i - 1]) : Vector4d(2 * b - c);
    const Vector4d d = i + 1 < last ? packed(knots[i + 2]) : Vector4d(2 * c - b);
    const int steps = std::max(1, static_cast<int>(std::ceil((c - b).head<3>().norm() / spacing)));
    for (int k = 0; k < steps; ++k) {
      const Vector4d at = spline(a, b, c, d, static_cast<double>(k) / steps);
      knots_.push_back({at.head<3>(), at.w()});
    }
  }
  knots_.push_back(knots.back());
  for (const Knot3& k : knots_) {
    box_.extend(k.p - Vector3d::Constant(k.r));
    box_.extend(k.p + Vector3d::Constant(k.r));
  }
}

double Cord::distance(const Vector3d& p) const {
  const double to_box = box_.exteriorDistance(p);
  if (to_box > reach) return to_box;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const Vector3d step = knots_[i + 1].p - knots_[i].p;
    const Vector3d off = p - knots_[i].p;
    const double t = std::clamp(off.dot(step) / step.squaredNorm(), 0.0, 1.0);
    const double r = knots_[i].r + t * (knots_[i + 1].r - knots_[i].r);
    least = std::min(least, (off - t * step).norm() - r);
  }
  return least;
}

}  // namespace fulcrum::content
