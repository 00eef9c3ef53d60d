#include "tools/content/sweep/ring.h"

#include <array>
#include <utility>
#include <vector>

#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/tube.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double ring_from = 10.4, ring_to = 15.8;  // mm, of the ring along the finger
constexpr double ring_middle = 0.5 * (ring_from + ring_to);
constexpr int around = 96;

// A band about the finger, its section given by (s, off the skin), counter-clockwise.
Solid band(const FingerShape& shape, const std::vector<Vector2d>& section) {
  std::vector<Section> sections;
  for (int k = 0; k < around; ++k) {
    Section& ring = sections.emplace_back();
    for (const Vector2d& p : section) ring.push_back(shape.surface(p.x(), 2.0 * pi * k / around, p.y()));
  }
  return closed_loft(sections);
}

// Over the end where the finger is cut off.
Solid cuff(const FingerShape& shape) {
  const Vector2d profile[] = {{37.0, -0.6}, {37.0, 0.5}, {37.4, 0.95}, {38.2, 1.05}, {39.6, 0.9},
                              {46.0, 1.0},  {47.0, 0.8}, {47.6, 0.0},  {47.8, -1.2}};
  std::vector<Section> sections;
  for (const Vector2d& at : profile) {
    Section& section = sections.emplace_back();
    for (int k = 0; k < around; ++k) section.push_back(shape.surface(at.x(), 2.0 * pi * k / around, at.y()));
  }
  return loft(sections);
}

Solid turned(std::span<const RadiusHeight> profile, const Vector3d& foot, const Vector3d& axis) {
  return transformed(lathe(profile, 56), frame_along(foot, axis));
}

}  // namespace

void add_ring(const FingerShape& shape, const RingMaterials& materials, Model* model) {
  const auto add = [&](const std::string& name, std::size_t material, Solid solid) {
    turn_outward(&solid);
    model->parts.push_back({.name = name, .material = material, .solid = std::move(solid)});
  };
  add("ring", materials.dark,
      band(shape, {{ring_from, -0.5},
                   {ring_from, 0.9},
                   {ring_from + 0.4, 1.3},
                   {ring_to - 0.4, 1.3},
                   {ring_to, 0.9},
                   {ring_to, -0.5}}));
  add("cuff", materials.cloth, cuff(shape));
  constexpr RadiusHeight coil[] = {{4.6, -1.0}, {4.6, 3.6}, {4.2, 4.0}, {3.2, 4.0}};
  constexpr RadiusHeight lid[] = {{3.3, 2.0}, {3.3, 4.2}, {3.0, 4.5}};
  constexpr RadiusHeight waist[] = {{4.75, 0.9}, {4.9, 1.1}, {4.9, 1.9}, {4.75, 2.1}};
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0.0 ? "left" : "right";
    const Vector3d out = side * Vector3d::UnitX();
    const Vector3d at = shape.surface(ring_middle, side < 0.0 ? pi : 0.0, 0.6);
    add(name + "/coil", materials.dark, turned(coil, at, out));
    add(name + "/cap", materials.bright, turned(lid, at, out));
    add(name + "/waist", materials.bright, turned(waist, at, out));
    const double high = side < 0.0 ? pi - 0.5 : 0.5;
    Centreline cable{.corners = {at + 2.2 * out, at + 2.2 * out + 7.0 * shape.along(ring_middle),
                                 shape.surface(24.0, high, 0.35), shape.surface(33.0, high, 0.35),
                                 shape.surface(40.0, high, -0.5)},
                     .bend_radius = 2.0};
    add(name + "/cable", materials.dark, tube(stations(cable), 0.55, 16, TubeEnd::flat, TubeEnd::flat));
  }
}

}  // namespace fulcrum::content
