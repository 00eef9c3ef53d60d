#include "tools/content/stick/ball.h"

#include <cmath>
#include <vector>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/board.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/paint.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

const Vector3d middle(0.0, -ball_radius, 0.0);

// Foam: a little lighter and darker from pore to pore.
Vector3d ball_colour(const Vector3d& p) {
  const double pores = 0.5 + 0.5 * mottle(1.9 * p / mm + Vector3d(3.1, 0.7, 5.9));
  return mixed(Vector3d(0.022, 0.13, 0.22), Vector3d(0.032, 0.18, 0.29), pores);
}

}  // namespace

Model make_ball() {
  constexpr int rings = 96;
  std::vector<RadiusHeight> profile;
  for (int k = 0; k <= rings; ++k) {
    const double angle = pi * (0.02 + 0.96 * k / rings) - 0.5 * pi;
    profile.push_back({ball_radius * math::cos(angle), ball_radius * math::sin(angle)});
  }
  profile.insert(profile.begin(), {0.4 * mm, -std::sqrt(ball_radius * ball_radius - 0.16 * mm * mm)});
  profile.push_back({0.4 * mm, -profile.front().z});
  Part part{.name = "ball", .material = 0, .solid = lathe(profile, 192)};
  for (const Vector3d& p : part.solid.points) {
    part.coat.normals.push_back(p.normalized());
    part.coat.colours.push_back(ball_colour(p));
  }
  part.solid = transformed(std::move(part.solid), Eigen::Isometry3d(Eigen::Translation3d(middle)));
  return {.name = "ball",
          .materials = {{.name = "foam", .base_colour = {1, 1, 1}, .metallic = 0.0, .roughness = 0.75}},
          .parts = {part}};
}

Model make_stand() {
  constexpr RadiusHeight turned[] = {
      {37 * mm, 0.0},         {38 * mm, 1 * mm},      {38 * mm, 5 * mm},      {37 * mm, 6 * mm},
      {16 * mm, 7.5 * mm},    {11 * mm, 9.5 * mm},    {8.8 * mm, 13 * mm},    {8 * mm, 18 * mm},
      {8 * mm, 30 * mm},      {8.8 * mm, 34.5 * mm},  {11.5 * mm, 39 * mm},   {17 * mm, 44.5 * mm},
      {23.4 * mm, 50.6 * mm}, {24.4 * mm, 52.4 * mm}, {23.6 * mm, 53.2 * mm}, {22.0 * mm, 52.6 * mm}};
  const Solid stand = transformed(lathe(turned, 96), frame_along({0, board_top, 0}, Vector3d::UnitY()));
  return {.name = "stand",
          .materials = {{.name = "turned aluminium",
                         .base_colour = {0.62, 0.63, 0.65},
                         .metallic = 1.0,
                         .roughness = 0.32}},
          .parts = {{.name = "stand", .material = 0, .solid = stand, .crease = 30 * degree}}};
}

Model make_table() {
  Model model{.name = "table",
              .materials = {{.name = "worktop",
                             .base_colour = {0.085, 0.095, 0.105},
                             .metallic = 0.0,
                             .roughness = 0.45}},
              .parts = {}};
  Eigen::Isometry3d X(Eigen::Translation3d(0.0, board_top - 0.5 * board_height, 0.0));
  X.rotate(turn_by(0.5 * pi, Vector3d::UnitY()));  // the grain from left to right
  add_board(&model, {.name = "board", .half = {75 * mm, 0.5 * board_height, 120 * mm}, .wood = oak}, X);
  const Vector3d half(0.8, 15.0 * mm, 0.5);
  const Eigen::Isometry3d X_top(Eigen::Translation3d(0.0, board_top - board_height - half.y(), -0.1));
  model.parts.push_back(
      {.name = "worktop", .material = 0, .solid = transformed(chamfered_box(half, 3.0 * mm), X_top)});
  return model;
}

}  // namespace fulcrum::content
