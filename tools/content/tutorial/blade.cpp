#include "tools/content/tutorial/blade.h"

#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

constexpr double neck_begins = 46.0 * mm, neck_ends = 70.0 * mm;
constexpr double neck_radius = 5.0 * mm;
constexpr double end = 96.0 * mm;   // in the handle
constexpr double blunt = 0.2 * mm;  // of the tip, so that its first section has a size

// Of a round end of that radius, so far from its top.
double of_round_end(double radius, double from_top) {
  if (from_top >= radius) return radius;
  return std::sqrt(radius * radius - (radius - from_top) * (radius - from_top));
}

// A rounded rectangle, which becomes a circle on the way to the handle.
Section section_at(double z) {
  constexpr int corners = 56;
  const double neck = smooth_step(neck_begins, neck_ends, z);
  const double width = std::lerp(of_round_end(blade_half_width, z + blunt), neck_radius, neck);
  const double thickness = std::lerp(of_round_end(blade_half_thickness, z + blunt), neck_radius, neck);
  const double power = 2.0 / std::lerp(5.0, 2.0, neck);  // of a superellipse
  const auto raised = [power](double c) {
    return c == 0.0 ? 0.0 : std::copysign(math::pow(std::abs(c), power), c);
  };
  Section section;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * pi * (k + 0.5) / corners;
    section.emplace_back(width * raised(math::cos(angle)), thickness * raised(math::sin(angle)), z);
  }
  return section;
}

Solid make_steel() {
  std::vector<Section> sections;
  for (double z = 0.0; z < end; z += z < 4.0 * mm ? 0.4 * mm : z < blade_half_width ? 1.0 * mm : 2.0 * mm)
    sections.push_back(section_at(z));
  sections.push_back(section_at(end));
  return loft(sections);
}

// A grip with a swell for the palm, and three rings turned into it.
Solid make_grip() {
  static const Profile profile({{84 * mm, 6.2 * mm},
                                {88 * mm, 8.6 * mm},
                                {104 * mm, 8.2 * mm},
                                {140 * mm, 10.6 * mm},
                                {168 * mm, 9.4 * mm},
                                {178 * mm, 7.0 * mm},
                                {181 * mm, 3.0 * mm}});
  std::vector<RadiusHeight> turned;
  for (int k = 0; k <= 194; ++k) {
    const double z = 84.0 * mm + 0.5 * mm * k;
    double r = profile(z);
    for (const double groove : {96.0, 100.5, 105.0}) r -= 0.7 * mm * bump(z - groove * mm, 0.9 * mm);
    turned.push_back({r, z});
  }
  return lathe(turned, 56);
}

}  // namespace

Model make_blade() {
  Model model{
      .name = "blade",
      .materials =
          {{.name = "satin steel", .base_colour = {0.58, 0.58, 0.59}, .metallic = 1.0, .roughness = 0.24},
           {.name = "grip", .base_colour = {0.015, 0.12, 0.30}, .metallic = 0.0, .roughness = 0.40}},
      .parts = {}};
  model.parts.push_back({.name = "steel", .material = 0, .solid = make_steel(), .crease = 60 * degree});
  model.parts.push_back({.name = "grip", .material = 1, .solid = make_grip(), .crease = 60 * degree});
  return model;
}

}  // namespace fulcrum::content
