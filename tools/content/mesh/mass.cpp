#include "tools/content/mesh/mass.h"

// Integrals over the tetrahedra from the origin to each triangle. The second moment of a tetrahedron with
// a corner at the origin: Tonon, "Explicit exact formulas for the 3-D tetrahedron inertia tensor", 2004.

namespace fulcrum::content {

MassProperties mass_properties(const Solid& solid, double density) {
  double volume = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Triangle& t : solid.triangles) {
    const Eigen::Vector3d& a = solid.points[t[0]];
    const Eigen::Vector3d& b = solid.points[t[1]];
    const Eigen::Vector3d& c = solid.points[t[2]];
    const double v = a.dot(b.cross(c)) / 6.0;
    const Eigen::Vector3d sum = a + b + c;
    volume += v;
    first += v * sum / 4.0;
    second += v / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  MassProperties result;
  result.mass = density * volume;
  result.centre = first / volume;
  const Eigen::Matrix3d about_centre = second - volume * result.centre * result.centre.transpose();
  result.inertia = density * (about_centre.trace() * Eigen::Matrix3d::Identity() - about_centre);
  return result;
}

}  // namespace fulcrum::content
