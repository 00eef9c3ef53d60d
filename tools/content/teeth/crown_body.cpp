#include "tools/content/teeth/crown_body.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

double depth_at(const std::vector<SideGroove>& grooves, double x, double z) {
  double depth = 0.0;
  for (const SideGroove& g : grooves)
    depth += g.depth * bump(x - g.x - g.lean * z, g.width) * smooth_step(g.from, g.to, z);
  return depth;
}

}  // namespace

double CrownBody::distance(const Eigen::Vector3d& p) const {
  const double z = p.z();
  const double side = p.y() > 0.0 ? buccal(z) - depth_at(buccal_grooves, p.x(), z)
                                  : lingual(z) - depth_at(lingual_grooves, p.x(), z);
  const double b = std::max(side, 0.05);
  const double across = p.y() / b;
  const double narrowing =
      1.0 + taper * across / std::sqrt(std::sqrt(1.0 + 0.2 * across * across * across * across));
  const double a = narrowing * (p.x() > 0.0 ? mesial(z) : distal(z));
  const double n = roundness(z);
  const double u = std::abs(p.x()) / a;
  const double v = std::abs(p.y()) / b;
  // The gauge r is 1 on the outline; divided by its slope it is a distance to first order.
  const double un = math::pow(u, n - 1.0);
  const double vn = math::pow(v, n - 1.0);
  const double sum = un * u + vn * v;
  if (sum < 1e-9) return -std::min(a, b);
  const double r = math::pow(sum, 1.0 / n);
  const double slope = math::hypot(un / a, vn / b) * r / sum;
  return (r - 1.0) / slope;
}

}  // namespace fulcrum::content
