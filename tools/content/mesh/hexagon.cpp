#include "tools/content/mesh/hexagon.h"

#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

constexpr double chamfer_slope = 0.57735026918962576;  // 30 degrees, as hexagon heads are turned

// Distance from the axis to the side of a hexagon with a corner at angle 0.
double hexagon_radius(double across_flats, double angle) {
  const double sector = pi / 3.0;
  const double from_corner = angle - sector * std::floor(angle / sector);
  return 0.5 * across_flats / math::cos(from_corner - 0.5 * sector);
}

}  // namespace

Section circle(double radius, double z, int columns) {
  Section section;
  for (int k = 0; k < columns; ++k) {
    const double angle = 2.0 * pi * k / columns;
    section.emplace_back(radius * math::cos(angle), radius * math::sin(angle), z);
  }
  return section;
}

Section hexagon(double across_flats, double z, int columns) {
  Section section;
  for (int k = 0; k < columns; ++k) {
    const double angle = 2.0 * pi * k / columns;
    const double r = hexagon_radius(across_flats, angle);
    section.emplace_back(r * math::cos(angle), r * math::sin(angle), z);
  }
  return section;
}

Section chamfered_hexagon(double across_flats, double z, double outward, int columns) {
  Section section = hexagon(across_flats, z, columns);
  for (Eigen::Vector3d& p : section)
    p.z() -= outward * chamfer_slope * (p.head<2>().norm() - flat_radius(across_flats));
  return section;
}

}  // namespace fulcrum::content
