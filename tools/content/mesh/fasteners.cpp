#include "tools/content/mesh/fasteners.h"

#include <array>

#include "tools/content/mesh/hexagon.h"

namespace fulcrum::content {

Solid bolt(const Thread& thread, double length, double threaded, int columns) {
  const double s = thread.across_flats;
  const double radius = 0.5 * thread.diameter;
  const double root = radius - 0.55 * thread.pitch;
  std::vector<Section> sections{
      circle(flat_radius(s), -thread.head_height, columns),
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
      circle(flat_radius(s), 0.0, columns),
      chamfered_hexagon(s, 0.0, -1.0, columns),
      chamfered_hexagon(s, h, 1.0, columns),
      circle(flat_radius(s), h, columns),
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
