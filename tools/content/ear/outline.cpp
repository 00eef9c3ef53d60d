#include "tools/content/ear/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fulcrum::content {

using Eigen::Vector2d;

Outline::Outline(const std::vector<Vector2d>& corners) {
  constexpr int steps = 8;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d& a = corners[(i + n - 1) % n];
    const Vector2d& b = corners[i];
    const Vector2d& c = corners[(i + 1) % n];
    const Vector2d& d = corners[(i + 2) % n];
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const double t2 = t * t;
      const double t3 = t2 * t;
      points_.emplace_back((2 * t3 - 3 * t2 + 1) * b + (t3 - 2 * t2 + t) * 0.5 * (c - a) +
                           (3 * t2 - 2 * t3) * c + (t3 - t2) * 0.5 * (d - b));
    }
  }
}

double Outline::distance(const Vector2d& p) const {
  double least2 = std::numeric_limits<double>::infinity();
  bool within = false;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector2d& a = points_[i];
    const Vector2d& b = points_[(i + 1) % points_.size()];
    const Vector2d step = b - a;
    const double t = std::clamp((p - a).dot(step) / step.squaredNorm(), 0.0, 1.0);
    least2 = std::min(least2, (p - a - t * step).squaredNorm());
    const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
    if (crosses && p.x() < a.x() + (p.y() - a.y()) / step.y() * step.x()) within = !within;
  }
  return within ? -std::sqrt(least2) : std::sqrt(least2);
}

}  // namespace fulcrum::content
