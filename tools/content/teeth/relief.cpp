#include "tools/content/teeth/relief.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

constexpr double deep_down = -1e3;

double power6(double x) {
  const double x2 = x * x;
  return x2 * x2 * x2;
}

double cusp_height(const Cusp& cusp, double x, double y) {
  const double dx = x - cusp.tip.x();
  const double dy = y - cusp.tip.y();
  const double far2 = dx * dx + dy * dy;
  if (far2 < 1e-12) return cusp.tip.z();
  const double far = std::sqrt(far2);
  const double cos_in = math::cos(cusp.inward);
  const double sin_in = math::sin(cusp.inward);
  const double in = (dx * cos_in + dy * sin_in) / far;
  const double aside = (dy * cos_in - dx * sin_in) / far;
  const double outward = smooth_step(0.0, 0.75, -in);
  double slope = cusp.flank + outward * (cusp.outer - cusp.flank);
  const double crest = power6(aside);
  slope += crest * (cusp.crest - slope);
  if (in > 0.0) slope += power6(in) * (cusp.ridge - slope);
  double height = cusp.tip.z() - slope * (std::sqrt(far2 + cusp.blunt * cusp.blunt) - cusp.blunt);
  if (in > 0.3 && cusp.wrinkles > 0.0) {
    const double beside = std::abs(math::atan2(aside, in)) - 0.55;
    height -= cusp.wrinkles * bump(beside, 0.17) * smooth_step(0.5, 1.4, far);
  }
  return height;
}

double ridge_height(const Ridge& ridge, double x, double y) {
  const Eigen::Vector2d line = (ridge.to - ridge.from).head<2>();
  const Eigen::Vector2d p = Eigen::Vector2d(x, y) - ridge.from.head<2>();
  const double t = std::clamp(p.dot(line) / line.squaredNorm(), 0.0, 1.0);
  const Eigen::Vector2d off = p - t * line;
  const double left = line.normalized().x() * p.y() - line.normalized().y() * p.x();
  const double slope =
      ridge.slope_right + smooth_step(-0.3, 0.3, left) * (ridge.slope_left - ridge.slope_right);
  const double far = std::sqrt(off.squaredNorm() + ridge.blunt * ridge.blunt) - ridge.blunt;
  const double top = ridge.from.z() + t * (ridge.to.z() - ridge.from.z()) - 4.0 * t * (1.0 - t) * ridge.sag;
  return top - slope * far;
}

}  // namespace

Relief::At Relief::at(double x, double y) const {
  const double wavy_x = x + waviness * math::sin(1.9 * y + 0.6 + phase) +
                        0.3 * waviness * math::sin(4.7 * y + 2.0 + 2.0 * phase);
  const double wavy_y =
      y + waviness * math::sin(1.7 * x + 1.1 + phase) + 0.3 * waviness * math::sin(4.3 * x + 2.0 * phase);
  double first = deep_down;
  double second = deep_down;
  for (const Cusp& cusp : cusps) {
    const double h = cusp_height(cusp, wavy_x, wavy_y);
    second = std::max(second, std::min(first, h));
    first = std::max(first, h);
  }
  At result{first, 0.0};
  if (cusps.size() > 1) {
    // Beside a valley the heights differ by about the sum of both slopes for each mm.
    const Eigen::Vector2d reach = (Eigen::Vector2d(x, y) - fissure_middle).cwiseQuotient(fissure_reach);
    const double fade = smooth_step(1.25, 0.8, reach.norm());
    result.fissure = bump(first - second, 1.8 * fissure_width) * fade;
    result.height = smooth_max(first, second, 0.2) - fissure_depth * result.fissure;
  }
  const double without = result.height;
  for (const Ridge& ridge : ridges)
    result.height = smooth_max(result.height, ridge_height(ridge, x, y), join);
  result.fissure *= smooth_step(0.35, 0.05, result.height - without);  // a ridge that runs over it fills it
  return result;
}

double Relief::height(double x, double y) const {
  return at(x, y).height;
}

double Relief::fissure(double x, double y) const {
  return at(x, y).fissure;
}

}  // namespace fulcrum::content
