#include "tools/content/sweep/finger.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"
#include "tools/content/mesh/surface_nets.h"
#include "tools/content/sweep/finger_shape.h"
#include "tools/content/sweep/ring.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double cell = 0.42;                           // mm
const std::vector<double> surroundings{0.5, 1.2, 2.5};  // mm

Solid net(const Implicit& body, const Vector3d& low, const Vector3d& high, double size) {
  const auto even = [size](double) { return size; };
  return surface_nets(body, {grid_line(low.x(), high.x(), even), grid_line(low.y(), high.y(), even),
                             grid_line(low.z(), high.z(), even)});
}

// Redder at the tip and over the joint; paler in between.
Vector3d skin_colour(const FingerShape& shape, const Vector3d& p) {
  const FingerShape::Place at = shape.place(p);
  const Vector3d pale(0.60, 0.355, 0.255), red(0.56, 0.245, 0.185);
  const double blood = 0.75 * smooth_step(5.0, -5.0, at.s) + 0.4 * bump(at.s - FingerShape::last_joint, 5.0) +
                       0.25 * bump(shape.from_nail(p) - 0.8, 0.9) * smooth_step(0.0, 3.0, at.h);
  return mixed(pale, red, blood + 0.1 * mottle(0.8 * p) + 0.05 * mottle(3.0 * p));
}

Vector3d nail_colour(const FingerShape& shape, const Vector3d& p) {
  const FingerShape::Place at = shape.place(p);
  const Vector3d pink(0.64, 0.36, 0.295), white(0.74, 0.66, 0.58);
  const double moon = smooth_step(0.6, -0.4, math::hypot(at.x / 1.15, at.s - 9.6) - 3.0);
  const double edge = smooth_step(-3.0, -3.5, at.s + 0.02 * at.x * at.x);
  return mixed(pink, white, std::max(0.4 * moon, 0.95 * edge));
}

template <typename Colour>
Part part_of(const char* name, std::size_t material, Solid solid, const Implicit& body, const Implicit& all,
             const Colour& colour) {
  Part part{.name = name, .material = material, .solid = std::move(solid)};
  for (Vector3d& p : part.solid.points) {
    const Vector3d n = gradient(body, p, 0.1).normalized();
    const Vector3d plain = colour(p);
    const Vector3d fine = 0.03 * Vector3d(mottle(6.0 * p), mottle(6.0 * p + Vector3d(5, 2, 8)),
                                          mottle(6.0 * p + Vector3d(1, 9, 4)));
    part.coat.normals.push_back((n + (material == 0 ? fine : Vector3d::Zero())).normalized());
    part.coat.colours.push_back(shut_in(plain, openness(all, p, n, surroundings), plain));
  }
  return part;
}

}  // namespace

Model make_finger() {
  const FingerShape shape;
  const Implicit skin = [&](const Vector3d& p) { return shape.skin(p); };
  const Implicit nail = [&](const Vector3d& p) { return shape.nail(p); };
  const Implicit both = [&](const Vector3d& p) { return std::min(shape.skin(p), shape.nail(p)); };
  Model model{
      .name = "finger",
      .materials =
          {{.name = "skin", .base_colour = {1, 1, 1}, .metallic = 0.0, .roughness = 0.55},
           {.name = "nail", .base_colour = {1, 1, 1}, .metallic = 0.0, .roughness = 0.22},
           {.name = "ring", .base_colour = {0.028, 0.032, 0.042}, .metallic = 0.35, .roughness = 0.36},
           {.name = "brass", .base_colour = {0.83, 0.60, 0.26}, .metallic = 1.0, .roughness = 0.30},
           {.name = "cuff", .base_colour = {0.035, 0.05, 0.075}, .metallic = 0.0, .roughness = 0.85}},
      .parts = {}};
  model.parts.push_back(part_of(
      "skin", 0, net(skin, {-12, -12, -10}, {12, 42, 52}, cell), skin, both,
      [&](const Vector3d& p) { return skin_colour(shape, p); }));
  model.parts.push_back(part_of("nail", 1, net(nail, {-7, -4, -8}, {7, 14, 12}, 0.22), nail, both,
                                [&](const Vector3d& p) { return nail_colour(shape, p); }));
  add_ring(shape, {.dark = 2, .bright = 3, .cloth = 4}, &model);
  double lowest = 0.0;
  for (const Vector3d& p : model.parts.front().solid.points) lowest = std::min(lowest, p.y());
  const Vector3d foot(0.0, lowest, shape.point({shape.lowest(), 0.0, -6.0}).z());
  for (Part& part : model.parts)
    for (Vector3d& p : part.solid.points) p = mm * (p - foot);
  return model;
}

}  // namespace fulcrum::content
