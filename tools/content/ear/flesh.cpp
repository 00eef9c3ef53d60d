#include "tools/content/ear/flesh.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The piece of the head: a rounded shield.
const Vector2d middle(-7.0, 4.0);      // mm
const Vector2d half_size(41.0, 47.0);  // mm

constexpr double membrane = 0.7;  // mm, thickness of the drum where it is cut open

}  // namespace

double Flesh::above_head(const Vector3d& p) const {
  const double x = p.x() - middle.x();
  const double y = p.y() - middle.y();
  const double cheek = 2.4 * smooth_step(-6.0, 14.0, p.x()) * smooth_step(30.0, 0.0, std::abs(p.y() + 6.0));
  return p.z() - (0.6 + cheek - 0.0016 * x * x - 0.0013 * y * y);
}

double Flesh::solid(const Vector3d& p) const {
  const double u = (p.x() - middle.x()) / half_size.x();
  const double v = (p.y() - middle.y()) / half_size.y();
  const double gauge = std::sqrt(math::hypot(u * u, v * v));
  const double sides = (gauge - 1.0) * half_size.x();
  double block = smooth_max(above_head(p), sides, 9.0);
  block = smooth_max(block, back - p.z(), 3.0);
  if (p.z() < -12.0) return block;
  return smooth_min(block, pinna_.distance(p), 4.0);
}

double Flesh::distance(const Vector3d& p) const {
  // Far outside the canal would go on: there its room ends.
  // At its end lies the drum, with its back in the flesh.
  const double to_end = canal_.to_drum(p) + 0.5 * membrane;
  const double room = smooth_min(smooth_min(canal_.to_wall(p), to_end, 1.5), 9.0 - p.z(), 2.0);
  return smooth_max(solid(p), room, 1.8);
}

double Flesh::before_cut(const Vector3d& p) const {
  const Vector3d from_axis = p - canal_.middle(std::clamp(-p.z(), -2.0, 26.0));
  // Outside it recedes to the front: the pinna stays.
  return cut_normal.dot(from_axis) - 2.5 * std::max(p.z(), 0.0);
}

double Flesh::to_membrane(const Vector3d& p_W, double rim) const {
  const Vector3d p = canal_.X_WD().inverse() * p_W;
  const double beyond = Canal::drum_half_width * (canal_.drum_part(p.x(), p.y()) - 1.0);
  const double sheet = std::abs(p.z() - canal_.drum_height(p.x(), p.y()) + 0.5 * membrane) - 0.5 * membrane;
  return smooth_max(sheet, beyond - rim, 0.3);
}

double Flesh::to_cavity(const Vector3d& p_W) const {
  const Vector3d p = canal_.X_WD().inverse() * p_W;
  // Behind the drum, and up into the attic.
  const Vector3d q = (p - Vector3d(0.0, 0.8, -2.4)).cwiseQuotient(Vector3d(4.6, 6.4, 3.6));
  const double room = (1.0 - q.norm()) * 3.6;
  return -smooth_min(room, canal_.drum_height(p.x(), p.y()) - membrane - p.z(), 0.3);
}

double Flesh::open_distance(const Vector3d& p) const {
  const double hollow = std::max(distance(p), -to_cavity(p));
  return smooth_max(hollow, before_cut(p), 0.5);
}

}  // namespace fulcrum::content
