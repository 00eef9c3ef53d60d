#include "tools/content/mesh/solid.h"

#include <cmath>
#include <utility>

namespace fulcrum::content {

std::uint32_t Solid::add_point(const Eigen::Vector3d& p) {
  points.push_back(p);
  return static_cast<std::uint32_t>(points.size() - 1);
}

void Solid::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  triangles.push_back({a, b, c});
}

void Solid::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  // The margin keeps rounding from choosing between two equal diagonals.
  const double ac = (points[a] - points[c]).norm();
  const double bd = (points[b] - points[d]).norm();
  if (bd < ac * (1.0 - 1e-6)) {
    add_triangle(a, b, d);
    add_triangle(b, c, d);
  } else {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }
}

Solid transformed(Solid solid, const Eigen::Isometry3d& X) {
  for (Eigen::Vector3d& p : solid.points) p = X * p;
  return solid;
}

double signed_volume(const Solid& solid) {
  double six_volumes = 0.0;
  for (const Triangle& t : solid.triangles)
    six_volumes += solid.points[t[0]].dot(solid.points[t[1]].cross(solid.points[t[2]]));
  return six_volumes / 6.0;
}

void turn_outward(Solid* solid) {
  if (signed_volume(*solid) >= 0.0) return;
  for (Triangle& t : solid->triangles) std::swap(t[1], t[2]);
}

Eigen::Isometry3d frame_along(const Eigen::Vector3d& origin, const Eigen::Vector3d& z_direction) {
  const Eigen::Vector3d z = z_direction.normalized();
  const Eigen::Vector3d aside = std::abs(z.y()) < 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d x = (aside - aside.dot(z) * z).normalized();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear().col(0) = x;
  X.linear().col(1) = z.cross(x);
  X.linear().col(2) = z;
  X.translation() = origin;
  return X;
}

}  // namespace fulcrum::content
