#include "tools/content/knock/bar.h"

#include <utility>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/wood.h"

namespace fulcrum::content {
namespace {

constexpr double grip_half = 45.0 * mm;
constexpr int bar_columns = 64;

Solid rod() {
  std::vector<RadiusHeight> profile;
  for (int k = 0; k < 8; ++k) {  // a round end
    const double angle = 0.5 * pi * (k + 0.25) / 8;
    profile.push_back({bar_radius * math::sin(angle), bar_end + bar_radius * (1.0 - math::cos(angle))});
  }
  for (double z = bar_end + bar_radius; z < -0.5 * grip_half; z += 2.0 * mm)
    profile.push_back({bar_radius, z});
  return lathe(profile, 32);
}

// A waist for the fingers, a bead before the ferrule, and a round knob.
Solid grip() {
  const Profile radius({{-45 * mm, 7.6 * mm},
                        {-40 * mm, 9.4 * mm},
                        {-34 * mm, 9.6 * mm},
                        {-26 * mm, 10.4 * mm},
                        {-2 * mm, 12.6 * mm},
                        {22 * mm, 11.6 * mm},
                        {36 * mm, 13.4 * mm},
                        {42 * mm, 12.0 * mm},
                        {44.4 * mm, 9.0 * mm},
                        {45 * mm, 6.0 * mm}});
  std::vector<RadiusHeight> profile;
  const auto pieces = 120;
  for (int k = 0; k <= pieces; ++k) {
    const double z = -grip_half + 2.0 * grip_half * k / pieces;
    profile.push_back({radius(z), z});
  }
  return lathe(profile, bar_columns);
}

}  // namespace

Model make_bar() {
  Model model{
      .name = "bar",
      .materials = {{.name = "steel", .base_colour = {0.56, 0.56, 0.57}, .metallic = 1.0, .roughness = 0.42},
                    {.name = "grip", .base_colour = {1.0, 1.0, 1.0}, .metallic = 0.0, .roughness = 0.38},
                    {.name = "brass", .base_colour = {0.72, 0.52, 0.24}, .metallic = 1.0, .roughness = 0.28}},
      .parts = {}};
  model.parts.push_back({.name = "rod", .material = 0, .solid = rod()});
  Part handle{.name = "grip", .material = 1, .solid = grip(), .crease = 60 * degree};
  handle.coat = grained(handle.solid, walnut);
  model.parts.push_back(std::move(handle));
  constexpr RadiusHeight ferrule[] = {{4.6 * mm, -57.0 * mm}, {6.2 * mm, -56.4 * mm}, {6.6 * mm, -55.4 * mm},
                                      {7.4 * mm, -50.0 * mm}, {8.6 * mm, -48.0 * mm}, {8.6 * mm, -44.6 * mm},
                                      {8.0 * mm, -44.0 * mm}};
  model.parts.push_back({.name = "ferrule", .material = 2, .solid = lathe(ferrule, bar_columns)});
  return model;
}

}  // namespace fulcrum::content
