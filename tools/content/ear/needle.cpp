#include "tools/content/ear/needle.h"

#include <algorithm>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/mass.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/round_bar.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double bend = 50.0 * degree;
constexpr double bend_radius = 2.5 * mm;
constexpr double bend_length = bend * bend_radius;
constexpr double bent_end = 10.0 * mm;   // from the tip to the middle of the bend
constexpr double shaft_end = 74.0 * mm;  // along the axis: buried in the handle
constexpr double handle_begins = 62.0 * mm;
constexpr double handle_length = 92.0 * mm;

constexpr Stretch stretches[] = {{bent_end - 0.5 * bend_length, 0.0},
                                 {bend_length, bend},
                                 {shaft_end - bent_end - 0.5 * bend_length, 0.0}};

// From a fine round tip to the shaft, which is thicker where it leaves the handle.
double radius(double along) {
  static const Profile profile({{0, 0.3 * mm},
                                {4 * mm, 0.42 * mm},
                                {8 * mm, 0.45 * mm},
                                {42 * mm, 0.45 * mm},
                                {52 * mm, 0.9 * mm},
                                {shaft_end, 1.2 * mm}});
  return profile(along);
}

double step(double along) {
  return along < 14 * mm ? 0.35 * mm : 0.7 * mm;
}

// The axis's points are where the walk of the bar puts them.
Vector3d axis(double along) {
  const double straight = bent_end - 0.5 * bend_length;
  const double heading = 0.5 * pi - bend;
  const auto direction = [](double h) { return Vector3d(0.0, math::cos(h), math::sin(h)); };
  if (along <= straight) return along * direction(heading);
  const double turned = std::min((along - straight) / bend_radius, bend);
  const Vector3d in_bend = bend_radius * Vector3d(0.0, math::sin(heading + turned) - math::sin(heading),
                                                  math::cos(heading) - math::cos(heading + turned));
  const double beyond = std::max(along - straight - bend_length, 0.0);
  return straight * direction(heading) + in_bend + beyond * Vector3d::UnitZ();
}

double handle_radius(double along) {
  static const Profile profile({{0, 1.3 * mm},
                                {1.5 * mm, 1.9 * mm},
                                {5 * mm, 2.5 * mm},
                                {7 * mm, 3.0 * mm},
                                {36 * mm, 3.0 * mm},
                                {39 * mm, 2.4 * mm},
                                {48 * mm, 2.2 * mm},
                                {78 * mm, 2.5 * mm},
                                {88 * mm, 2.9 * mm},
                                {91 * mm, 2.6 * mm},
                                {handle_length, 1.8 * mm}});
  return profile(along);
}

// Two families of grooves that wind about the grip and cross.
double knurl(double along, double angle) {
  if (along < 8 * mm || along > 35 * mm) return 0.0;
  constexpr int starts = 14;
  const double lead = starts * (along / (4.0 * mm)) * 0.5;
  const auto groove = [](double phase) {
    const double s = math::sin(phase);
    return math::exp(-s * s / 0.16);
  };
  return 0.2 * mm * std::max(groove(0.5 * starts * angle + lead), groove(0.5 * starts * angle - lead));
}

Solid handle() {
  constexpr int columns = 140;
  const Vector3d from = axis(handle_begins);
  std::vector<Section> sections;
  double along = 0.0;
  while (along <= handle_length + 1e-9) {
    Section& section = sections.emplace_back();
    for (int k = 0; k < columns; ++k) {
      const double angle = 2.0 * pi * k / columns;
      const double r = handle_radius(along) - knurl(along, angle);
      section.push_back(from + Vector3d(r * math::cos(angle), r * math::sin(angle), along));
    }
    const bool grip = along > 7.5 * mm && along < 35.5 * mm;
    const bool end = along < 7.5 * mm || along > 86 * mm;
    along += grip ? 0.25 * mm : end ? 0.5 * mm : 1.0 * mm;
  }
  return loft(sections);
}

}  // namespace

std::vector<Ball> needle_balls() {
  std::vector<Ball> balls;
  for (double along = 0.0; along < handle_begins; along += along < 12 * mm ? 0.4 * mm : 0.8 * mm)
    balls.push_back({axis(along) / mm, radius(along) / mm});
  return balls;
}

Vector3d needle_centre() {
  double mass = 0.0;
  Vector3d moment = Vector3d::Zero();
  for (const Part& part : make_needle().parts) {
    const MassProperties properties = mass_properties(part.solid, steel_density);
    mass += properties.mass;
    moment += properties.mass * properties.centre;
  }
  return moment / mass;
}

Model make_needle() {
  Model model{
      .name = "needle",
      .materials =
          {{.name = "surgical steel", .base_colour = {0.56, 0.56, 0.57}, .metallic = 1.0, .roughness = 0.24},
           {.name = "handle", .base_colour = {0.5, 0.5, 0.51}, .metallic = 1.0, .roughness = 0.36}},
      .parts = {}};
  model.parts.push_back({.name = "needle",
                         .material = 0,
                         .solid = round_bar(stretches, 0.5 * pi - bend, radius, step, 24),
                         .crease = 50 * degree});
  model.parts.push_back({.name = "handle", .material = 1, .solid = handle(), .crease = 60 * degree});
  return model;
}

}  // namespace fulcrum::content
