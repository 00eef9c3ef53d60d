#include "tools/content/piping/fasteners.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"

namespace fulcrum::content {
namespace {

constexpr double chamfer_slope = 0.57735026918962576;  // 30 degrees, as hexagon heads are turned

// Distance from the axis to the side of a hexagon with a corner at angle 0.
double hexagon_radius(double across_flats, double angle) {
  const double sector = pi / 3.0;
  const double from_corner = angle - sector * std::floor(angle / sector);
  return 0.5 * across_flats / math::cos(from_corner - 0.5 * sector);
}

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

// The edge where a hexagon meets the cone that chamfers its end at z. `outward` is the sign of the end's
// direction along z.
Section chamfered_hexagon(double across_flats, double z, double outward, int columns) {
  const double flat_radius = 0.475 * across_flats;
  Section section = hexagon(across_flats, z, columns);
  for (Eigen::Vector3d& p : section) p.z() -= outward * chamfer_slope * (p.head<2>().norm() - flat_radius);
  return section;
}

}  // namespace

Solid bolt(const Thread& thread, double length, double threaded, int columns) {
  const double s = thread.across_flats;
  const double radius = 0.5 * thread.diameter;
  const double root = radius - 0.55 * thread.pitch;
  std::vector<Section> sections{
      circle(0.475 * s, -thread.head_height, columns),
      chamfered_hexagon(s, -thread.head_height, -1.0, columns),
      hexagon(s, 0.0, columns),
      circle(radius, 0.0, columns),
  };
  const int turns = static_cast<int>(threaded / thread.pitch);
  const double tip = length - 0.6 * thread.pitch;
  for (int i = turns; i > 0; --i) {
    const double crest = tip - i * thread.pitch;
    sections.push_back(circle(radius, crest, columns));
    sections.push_back(circle(root, crest + 0.5 * thread.pitch, columns));
  }
  sections.push_back(circle(radius, tip, columns));
  sections.push_back(circle(root, length, columns));
  return loft(sections);
}

Solid nut(const Thread& thread, int columns) {
  const double s = thread.across_flats;
  const double h = thread.nut_height;
  const std::vector<Section> sections{
      circle(0.475 * s, 0.0, columns),
      chamfered_hexagon(s, 0.0, -1.0, columns),
      chamfered_hexagon(s, h, 1.0, columns),
      circle(0.475 * s, h, columns),
  };
  return loft(sections);
}

Solid washer(const Thread& thread, int columns) {
  constexpr double chamfer = 0.35 * mm;
  const double r = thread.washer_radius;
  const double h = thread.washer_height;
  const std::array<RadiusHeight, 3> profile{{{r, 0.0}, {r, h - chamfer}, {r - chamfer, h}}};
  return lathe(profile, columns);
}

}  // namespace fulcrum::content
