#include "tools/content/sweep/tablet.h"

#include <cmath>
#include <utility>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/board.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/prism.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double desk_top = -9.0 * mm;        // y
const Vector2d tablet_middle(0.0, 6.0 * mm);  // of the tablet: x, z

// Level, `half` each way, from one height to another.
Solid rounded_plate(const Vector2d& half, double corner, double low, double high, double bevel) {
  constexpr int pieces = 6;
  Outline outline;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double turn = 0.5 * pi * quarter;
    const Vector2d inner(std::copysign(half.x() - corner, math::cos(turn + 0.25 * pi)),
                         std::copysign(half.y() - corner, math::sin(turn + 0.25 * pi)));
    for (int k = 0; k <= pieces; ++k) {
      const double angle = turn + 0.5 * pi * k / pieces;
      outline.emplace_back(inner + corner * Vector2d(math::cos(angle), math::sin(angle)));
    }
  }
  // The drawing's y is towards -z.
  Eigen::Isometry3d X(Eigen::Translation3d(tablet_middle.x(), 0.5 * (low + high), tablet_middle.y()));
  X.rotate(turn_by(-0.5 * pi, Vector3d::UnitX()));
  return transformed(bevelled_prism(outline, 0.5 * (high - low), bevel), X);
}

Part line(const std::string& name, std::size_t material, const Vector2d& from, const Vector2d& to,
          double height) {
  const Vector3d half(0.5 * (to.x() - from.x()), 0.5 * height + 0.5 * mm, 0.5 * (to.y() - from.y()));
  const Vector3d at(0.5 * (from.x() + to.x()), 0.5 * height - 0.5 * mm, 0.5 * (from.y() + to.y()));
  return {.name = name,
          .material = material,
          .solid = transformed(chamfered_box(half, 0.02 * mm), Eigen::Isometry3d(Eigen::Translation3d(at)))};
}

}  // namespace

Model make_tablet() {
  return {.name = "tablet",
          .materials =
              {{.name = "glass", .base_colour = {0.012, 0.015, 0.019}, .metallic = 0.0, .roughness = 0.14},
               {.name = "case", .base_colour = {0.42, 0.43, 0.45}, .metallic = 1.0, .roughness = 0.36}},
          .parts = {{.name = "glass",
                     .material = 0,
                     .solid = rounded_plate({122 * mm, 78 * mm}, 9 * mm, -6 * mm, 0.0, 0.3 * mm)},
                    {.name = "case",
                     .material = 1,
                     .solid = rounded_plate({126 * mm, 82 * mm}, 13 * mm, desk_top, -0.5 * mm, 0.8 * mm)}}};
}

Model make_window_marks() {
  Model model{
      .name = "marks",
      .materials =
          {{.name = "window", .base_colour = {0.018, 0.052, 0.075}, .metallic = 0.0, .roughness = 0.25},
           {.name = "window line", .base_colour = {0.10, 0.55, 0.70}, .metallic = 0.0, .roughness = 0.5},
           {.name = "white line", .base_colour = {0.78, 0.78, 0.76}, .metallic = 0.0, .roughness = 0.5}},
      .parts = {}};
  constexpr double front = -36.0 * mm, back = 20.0 * mm;
  constexpr double low = 0.08 * mm, high = 0.14 * mm;
  const auto add = [&](Part part) { model.parts.push_back(std::move(part)); };
  add(line("window", 0, {-window_half, front}, {window_half, back}, low));
  add(line("centre", 2, {-0.45 * mm, front}, {0.45 * mm, back}, high));
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? "left" : "right";
    add(line(name, 1, {side * window_half - 0.3 * mm, front}, {side * window_half + 0.3 * mm, back}, high));
    add(line("turn/" + name, 2, {side * turn_at - 0.3 * mm, target_z - 5 * mm},
             {side * turn_at + 0.3 * mm, target_z + 5 * mm}, high));
  }
  add(line("way", 2, {-turn_at, target_z - 0.2 * mm}, {turn_at, target_z + 0.2 * mm}, high));
  return model;
}

Model make_desk() {
  Model model{.name = "desk", .materials = {}, .parts = {}};
  Eigen::Isometry3d X(Eigen::Translation3d(0.0, desk_top - 12 * mm, 0.0));
  X.rotate(turn_by(0.5 * pi, Vector3d::UnitY()));
  add_board(&model, {.name = "desk", .half = {190 * mm, 12 * mm, 290 * mm}, .wood = walnut}, X);
  return model;
}

}  // namespace fulcrum::content
