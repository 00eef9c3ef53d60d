#include "tools/content/tutorial/room.h"

#include <string>
#include <utility>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/board.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/painted_line.h"
#include "tools/content/mesh/prism.h"
#include "tools/content/mesh/wood.h"
#include "tools/content/tutorial/places.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Lines in the unit of a figure's height; a corner is where two of them meet.
std::vector<PaintedLine> figure(int number) {
  switch (number) {
    case 1:
      return {{{0.10, 0.80}, {0.30, 1.0}}, {{0.30, 1.03}, {0.30, 0.0}}};
    case 2: {
      PaintedLine line = arc({0.28, 0.73}, {0.25, 0.27}, 165.0, -35.0);
      line.emplace_back(0.02, 0.0);
      line.emplace_back(0.56, 0.0);
      return {line};
    }
    case 3:
      return {arc({0.26, 0.76}, {0.24, 0.24}, 155.0, -90.0), arc({0.26, 0.26}, {0.28, 0.26}, 90.0, -155.0)};
    case 4:
      return {{{0.44, 0.0}, {0.44, 1.0}}, {{0.44, 1.0}, {0.0, 0.30}}, {{-0.03, 0.30}, {0.60, 0.30}}};
    default:  // 5
      return {{{0.52, 1.0}, {0.07, 1.0}},
              {{0.10, 1.0}, {0.06, 0.53}},
              arc({0.26, 0.31}, {0.28, 0.31}, 133.0, -150.0)};
  }
}

// The side of the stand: it holds the panel's back, and stands on the bench.
Outline side_outline() {
  const Isometry3d X_WP = panel_in_world();
  const auto in_drawing = [](const Vector3d& p_W) { return Vector2d(-p_W.z(), p_W.y()); };
  const double back = -2.0 * panel_half.z() + 0.5 * mm;
  const Vector2d top = in_drawing(X_WP * Vector3d(0, 70 * mm, back));
  const Vector2d low = in_drawing(X_WP * Vector3d(0, -112 * mm, back));
  return {{low.x(), bench_height}, {top.x() + 78 * mm, bench_height}, {top.x() + 18 * mm, top.y()}, top, low};
}

}  // namespace

Model make_bench() {
  Model model{.name = "bench",
              .materials = {{.name = "wood", .base_colour = {1, 1, 1}, .metallic = 0.0, .roughness = 0.55},
                            {.name = "worktop",
                             .base_colour = {0.075, 0.09, 0.105},
                             .metallic = 0.0,
                             .roughness = 0.42}},
              .parts = {}};
  const Vector3d half(0.75, 15.0 * mm, 0.50);
  const Isometry3d X(Eigen::Translation3d(0.0, bench_height - half.y(), -0.05));
  model.parts.push_back(
      {.name = "worktop", .material = 1, .solid = transformed(chamfered_box(half, 3.0 * mm), X)});
  // The drawing's x goes away from the trainee, and its thickness along x.
  Eigen::Matrix3d turn;
  turn.col(0) = -Vector3d::UnitZ();
  turn.col(1) = Vector3d::UnitY();
  turn.col(2) = Vector3d::UnitX();
  for (const double x : {-110.0 * mm, 110.0 * mm}) {
    Isometry3d X_WD = Isometry3d::Identity();
    X_WD.linear() = turn;
    X_WD.translation().x() = x;
    Solid solid = bevelled_prism(side_outline(), 10.0 * mm, 1.5 * mm, 4.0 * mm);
    Coat coat = grained(solid, walnut);
    model.parts.push_back({.name = x < 0 ? "side/left" : "side/right",
                           .material = 0,
                           .solid = transformed(std::move(solid), X_WD),
                           .coat = std::move(coat)});
  }
  // A ledge that the panel's lower edge rests on.
  Isometry3d X_PL = Isometry3d::Identity();
  X_PL.linear().col(0) = Vector3d::UnitZ();
  X_PL.linear().col(1) = -Vector3d::UnitY();
  X_PL.linear().col(2) = Vector3d::UnitX();
  X_PL.translation() = Vector3d(0.0, -panel_half.y() - 5.5 * mm, -panel_half.z() + 2.0 * mm);
  add_board(&model,
            {.name = "ledge", .half = {14.0 * mm, 6.0 * mm, panel_half.x() + 12.0 * mm}, .wood = walnut},
            panel_in_world() * X_PL);
  return model;
}

Model make_numbers() {
  constexpr double height = 17.0 * mm, stroke = 1.7 * mm;  // half its width
  Model model{.name = "numbers",
              .materials =
                  {{.name = "paint", .base_colour = {0.05, 0.035, 0.025}, .metallic = 0.0, .roughness = 0.6}},
              .parts = {}};
  const Vector2d places[] = {{-158.0 * mm, 84.0 * mm},
                             {-12.0 * mm, 84.0 * mm},
                             {-158.0 * mm, -22.0 * mm},
                             {-38.0 * mm, -22.0 * mm},
                             {62.0 * mm, -22.0 * mm}};
  for (int number = 1; number <= 5; ++number) {
    const Vector2d& at = places[number - 1];
    const Isometry3d X_WF = panel_in_world() * Eigen::Translation3d(at.x(), at.y(), 0.0);
    for (const PaintedLine& line : figure(number))
      model.parts.push_back({.name = "number/" + std::to_string(model.parts.size() + 1),
                             .material = 0,
                             .solid = painted(line, height, stroke, X_WF)});
  }
  return model;
}

}  // namespace fulcrum::content
