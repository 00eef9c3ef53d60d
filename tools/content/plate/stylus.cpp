#include "tools/content/plate/stylus.h"

#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/round_bar.h"

namespace fulcrum::content {
namespace {

constexpr double length = 163.0 * mm;  // of the axis; the tip's cap is beyond it
constexpr double grasp = 120.0 * mm;

// A hard tip, a slim cone, the barrel, and a rounded end.
double radius(double along) {
  static const Profile profile({{0, stylus_tip_radius},
                                {7 * mm, stylus_tip_radius},
                                {8 * mm, 2.3 * mm},
                                {34 * mm, 4.2 * mm},
                                {60 * mm, 4.6 * mm},
                                {140 * mm, 4.6 * mm},
                                {160 * mm, 4.2 * mm},
                                {length, 3.6 * mm}});
  return profile(along);
}

// Two pairs of rings turned into the barrel.
double turned(double along) {
  for (const double at : {46.0, 48.5, 148.0, 150.5}) {
    const double off = std::abs(along - at * mm);
    if (off < 0.6 * mm) return radius(along) - 0.35 * mm * (0.5 + 0.5 * math::cos(pi * off / (0.6 * mm)));
  }
  return radius(along);
}

double step(double along) {
  const bool ringed = (along > 45 * mm && along < 50 * mm) || (along > 147 * mm && along < 152 * mm);
  return along < 9 * mm ? 0.4 * mm : ringed ? 0.2 * mm : 1.0 * mm;
}

}  // namespace

Model make_stylus() {
  constexpr int columns = 40;
  Model model{
      .name = "stylus",
      .materials =
          {{.name = "satin steel", .base_colour = {0.56, 0.56, 0.57}, .metallic = 1.0, .roughness = 0.26},
           {.name = "band", .base_colour = {0.85, 0.20, 0.02}, .metallic = 0.0, .roughness = 0.45}},
      .parts = {}};
  constexpr Stretch straight[] = {{length, 0.0}};
  model.parts.push_back({.name = "rod",
                         .material = 0,
                         .solid = round_bar(straight, 0.5 * pi, turned, step, columns),
                         .crease = 50 * degree});
  constexpr RadiusHeight band[] = {{4.2 * mm, grasp - 5.0 * mm},  {4.85 * mm, grasp - 4.6 * mm},
                                   {5.0 * mm, grasp - 4.2 * mm},  {5.0 * mm, grasp + 4.2 * mm},
                                   {4.85 * mm, grasp + 4.6 * mm}, {4.2 * mm, grasp + 5.0 * mm}};
  model.parts.push_back({.name = "band", .material = 1, .solid = lathe_ring(band, columns)});
  return model;
}

}  // namespace fulcrum::content
