#include "tools/content/mesh/paint.h"

// Openness, from how fast what is around a point recedes along its normal: A. Evans, "Fast Approximations for
// Global Illumination on Dynamic Scenes", SIGGRAPH 2006 course.

#include <algorithm>

#include "haptics/math/functions.h"

namespace fulcrum::content {

using Eigen::Vector3d;

Vector3d mixed(const Vector3d& a, const Vector3d& b, double t) {
  return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

double mottle(const Vector3d& p) {
  return math::sin(p.x() + 1.7 * math::sin(0.7 * p.y() + 0.4 * p.z())) *
         math::sin(p.y() + 1.3 * math::sin(0.8 * p.z() - 0.3 * p.x())) *
         math::sin(p.z() + 1.5 * math::sin(0.6 * p.x()));
}

double openness(const Implicit& scene, const Vector3d& p, const Vector3d& n,
                const std::vector<double>& reaches) {
  double shut = 0.0;
  double weight = 0.0;
  for (const double far : reaches) {
    const double share = 1.0 / (0.6 + far);
    shut += share * std::clamp((far - scene(p + far * n)) / far, 0.0, 1.0);
    weight += share;
  }
  const double open = 1.0 - shut / weight;
  return std::clamp(open, 0.0, 1.0);
}

Vector3d shut_in(const Vector3d& colour, double open, const Vector3d& walls) {
  const Vector3d bounced = Vector3d::Constant(0.25) + 0.75 * walls;
  return colour.cwiseProduct(mixed(0.55 * bounced, Vector3d::Ones(), open));
}

}  // namespace fulcrum::content
