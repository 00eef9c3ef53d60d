#include "tools/content/nut/plant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/steel.h"
#include "tools/content/mesh/tube.h"
#include "tools/content/nut/nut_part.h"
#include "tools/content/nut/place.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

enum Finish : std::size_t {
  pump_blue,
  green_paint,
  bare_steel,
  zinc,
  dark_zinc,
  gasket_red,
  wall_grey,
  rail,
  turned_steel
};

constexpr double steel_size = 34.0 * mm;  // of the picture of turned steel

std::vector<Material> finishes() {
  // Colours after RAL 5010 (the pump), RAL 6011 (water) and RAL 7035 (the wall), linear.
  return {
      painted("paint, blue", {0.012, 0.055, 0.145}),       painted("paint, water green", {0.085, 0.19, 0.12}),
      brushed("bare steel", {0.46, 0.45, 0.43}, 0.34),     brushed("zinc", {0.50, 0.51, 0.52}, 0.32),
      {"dark zinc", {0.20, 0.20, 0.21}, 1.0, 0.38},        {"gasket", {0.16, 0.045, 0.03}, 0.0, 0.9},
      {"paint, light grey", {0.50, 0.51, 0.49}, 0.0, 0.6}, {"rail", {0.50, 0.52, 0.54}, 1.0, 0.48},
      brushed("turned steel", {0.56, 0.55, 0.53}, 0.30)};
}

void add(Model* model, std::string name, std::size_t finish, const Vector3d& p, Solid solid) {
  model->parts.push_back({.name = std::move(name),
                          .material = finish,
                          .solid = transformed(std::move(solid), Isometry3d(Translation3d(p)))});
}

// How often a picture of steel goes round what is as wide as that, its lines as close on a small part as on a
// large one.
Tiling turned(double radius) {
  return {std::max(1, static_cast<int>(std::lround(2.0 * pi * radius / steel_size))), steel_size};
}

void add_unwrapped(Model* model, std::string name, std::size_t finish, const Isometry3d& X_WS, Solid solid,
                   CornerUv uv, Coat coat = {}) {
  model->parts.push_back({.name = std::move(name),
                          .material = finish,
                          .solid = transformed(std::move(solid), X_WS),
                          .coat = std::move(coat),
                          .uv = std::move(uv)});
}

// The middle of the cover, from the bare bolt.
Vector3d cover_middle() {
  const double off = bolt_circle * math::cos(0.25 * pi);
  return {-off, -off, 0.0};
}

constexpr double cover_radius = 48.0 * mm;
constexpr int cover_columns = 72;
constexpr double cover_back = cover_face - 13.0 * mm;
constexpr double gasket_back = cover_back - 2.5 * mm;

Solid cover_disc() {
  // From the rim at its back to the hub in its middle.
  constexpr std::array<RadiusHeight, 9> profile{{{cover_radius - 0.8 * mm, cover_back},
                                                 {cover_radius, cover_back + 0.8 * mm},
                                                 {cover_radius, cover_face - 1.2 * mm},
                                                 {cover_radius - 1.2 * mm, cover_face},
                                                 {19.0 * mm, cover_face},
                                                 {17.4 * mm, cover_face + 0.7 * mm},
                                                 {15.0 * mm, cover_face + 6.0 * mm},
                                                 {14.0 * mm, cover_face + 7.0 * mm},
                                                 {8.0 * mm, cover_face + 7.0 * mm}}};
  return lathe(profile, cover_columns);
}

Solid housing() {
  constexpr double front = gasket_back, back = wall_face - 5.0 * mm;
  constexpr std::array<RadiusHeight, 8> profile{{{40.0 * mm, back},
                                                 {40.0 * mm, front - 40.0 * mm},
                                                 {41.5 * mm, front - 24.0 * mm},
                                                 {44.5 * mm, front - 19.0 * mm},
                                                 {cover_radius, front - 17.0 * mm},
                                                 {cover_radius + 1.0 * mm, front - 15.0 * mm},
                                                 {cover_radius + 1.0 * mm, front - 0.8 * mm},
                                                 {cover_radius + 0.2 * mm, front}}};
  return lathe(profile, cover_columns);
}

void add_bolts(Model* model) {
  const Vector3d middle = cover_middle();
  for (int k = 0; k < 4; ++k) {
    const double angle = (0.25 + 0.5 * k) * pi;
    const Vector3d at =
        k == 0 ? Vector3d::Zero().eval()
               : (middle + bolt_circle * Vector3d(math::cos(angle), math::sin(angle), 0.0)).eval();
    const std::string number = std::to_string(k + 1);
    const Solid disc = washer(m12_iso, 48);
    add_unwrapped(model, "washer/" + number, zinc,
                  Isometry3d(Translation3d(at - m12_iso.washer_height * Vector3d::UnitZ())), disc,
                  unwrapped_sections(disc, 48, turned(m12_iso.washer_radius)), worn(disc));
    if (k == 0) {
      add(model, "bolt/1", dark_zinc, at, bare_bolt());
      continue;
    }
    const auto turn_to = [&](double degrees, double z) {
      return Isometry3d(Translation3d(at + z * Vector3d::UnitZ()) *
                        turn_by(degrees * degree, Vector3d::UnitZ()));
    };
    constexpr double head = gasket_back - 17.0 * mm;
    model->parts.push_back({.name = "bolt/" + number,
                            .material = dark_zinc,
                            .solid = transformed(bolt(m12_iso, bolt_end - head, 2.0 * m12_iso.pitch, 36),
                                                 turn_to(31.0 * k, head))});
    const Solid hexagon = nut(m12_iso, 36);
    add_unwrapped(model, "nut/" + number, zinc, turn_to(23.0 * k + 11.0, 0.0), hexagon,
                  unwrapped_sections(hexagon, 36, turned(0.5 * m12_iso.across_flats)), worn(hexagon));
  }
}

Solid pipe(const std::vector<Vector3d>& corners, double radius, int columns) {
  return tube(stations({corners, 3.0 * radius, 7.5 * degree, 0.6 * mm}), radius, columns, TubeEnd::cut,
              TubeEnd::cut);
}

// The pipes run out of the picture.
std::vector<Vector3d> pipe_in_the_way() {
  return {{-0.42, 0.0, pipe_z}, {pipe_turns_x, 0.0, pipe_z}, {pipe_turns_x, 0.36, pipe_z}};
}
std::vector<Vector3d> pipe_below() {
  return {{-0.42, -92.0 * mm, 20.0 * mm}, {0.42, -92.0 * mm, 20.0 * mm}};
}

// A rod from the wall to a pipe, and the clip on its end.
void add_holder(Model* model, const std::string& name, const Vector3d& on_pipe, const Vector3d& along,
                double radius) {
  const double length = on_pipe.z() - wall_face;
  const std::array<RadiusHeight, 4> rod{
      {{9.0 * mm, -2.0 * mm}, {9.0 * mm, 4.0 * mm}, {5.0 * mm, 5.0 * mm}, {5.0 * mm, length}}};
  add(model, "holder/" + name, rail, {on_pipe.x(), on_pipe.y(), wall_face}, lathe(rod, 32));
  const double inner = radius - 0.5 * mm, outer = radius + 2.5 * mm, half = 8.0 * mm;
  const std::array<RadiusHeight, 6> clip{{{inner, -half},
                                          {outer - 0.6 * mm, -half},
                                          {outer, 0.6 * mm - half},
                                          {outer, half - 0.6 * mm},
                                          {outer - 0.6 * mm, half},
                                          {inner, half}}};
  model->parts.push_back({.name = "clip/" + name,
                          .material = rail,
                          .solid = transformed(lathe_ring(clip, 48), frame_along(on_pipe, along))});
}

}  // namespace

Model make_cover() {
  Model model{.name = "cover", .materials = finishes(), .parts = {}};
  const Vector3d middle = cover_middle();
  const Isometry3d X_WC(Translation3d{middle});
  const Solid disc = cover_disc(), body = housing();
  add_unwrapped(&model, "cover", turned_steel, X_WC, disc,
                unwrapped_sections(disc, cover_columns, turned(cover_radius)), worn(disc));
  constexpr std::array<RadiusHeight, 2> seal{
      {{cover_radius - 2.0 * mm, gasket_back}, {cover_radius - 2.0 * mm, cover_back}}};
  add(&model, "gasket", gasket_red, middle, lathe(seal, 72));
  add_unwrapped(&model, "housing", pump_blue, X_WC, body,
                unwrapped_sections(body, cover_columns, {4, pi * cover_radius, 0.27}));
  // The plug in the hub.
  const Solid plug = nut({0, 0, 13.0 * mm, 0, 7.0 * mm, 0, 0}, 36);
  add_unwrapped(&model, "plug", bare_steel,
                Isometry3d(Translation3d(middle + (cover_face + 6.0 * mm) * Vector3d::UnitZ())), plug,
                unwrapped_sections(plug, 36, turned(6.5 * mm)), worn(plug));
  add_bolts(&model);
  const Solid green = pipe(pipe_in_the_way(), pipe_radius, 48), bare = pipe(pipe_below(), 8.0 * mm, 36);
  const double to_bend = pipe_turns_x + 0.42;
  add_unwrapped(&model, "pipe/1", green_paint, Isometry3d::Identity(), green,
                unwrapped_sections(
                    green, 48, {1, 4.0 * pi * pipe_radius, worn_at - to_bend / (4.0 * pi * pipe_radius)}));
  add_unwrapped(&model, "pipe/2", bare_steel, Isometry3d::Identity(), bare,
                unwrapped_sections(bare, 36, turned(8.0 * mm)));
  return model;
}

Model make_wall() {
  Model model{.name = "wall", .materials = finishes(), .parts = {}};
  add(&model, "wall", wall_grey, {0.0, 0.0, wall_face - 10.0 * mm},
      chamfered_box({1.6, 1.2, 10.0 * mm}, 1.5 * mm));
  add_holder(&model, "left", {-0.13, 0.0, pipe_z}, Vector3d::UnitX(), pipe_radius);
  add_holder(&model, "right", {pipe_turns_x, 0.15, pipe_z}, Vector3d::UnitY(), pipe_radius);
  add_holder(&model, "below", {-0.11, -92.0 * mm, 20.0 * mm}, Vector3d::UnitX(), 8.0 * mm);
  add_holder(&model, "below right", {0.12, -92.0 * mm, 20.0 * mm}, Vector3d::UnitX(), 8.0 * mm);
  return model;
}

}  // namespace fulcrum::content
