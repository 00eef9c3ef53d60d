#include "tools/content/knock/pegs.h"

#include <utility>

#include "haptics/math/functions.h"
#include "tools/content/mesh/board.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/wood.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double board_x = -112.0 * mm;  // the upright board's face
constexpr double floor_y = -92.0 * mm;   // the lying board's face
constexpr double level_tip = 24.0 * mm;  // x of the ends of the pegs above and below
constexpr double foot = 2.0 * mm;        // how deep a peg goes into its board
constexpr int columns = 40;

struct Peg {
  std::string name;
  Eigen::Isometry3d X_WP;  // its foot at the origin, the peg along z
  double length = 0.0;     // m, from there to its round end
};

Peg peg(const std::string& name, const Vector3d& from, const Vector3d& to) {
  const Vector3d direction = (to - from).normalized();
  return {name, frame_along(from - foot * direction, direction), (to - from).norm() + foot};
}

std::vector<Peg> at_station(const PegStation& station) {
  const double off = station.room + peg_radius;
  const double z = station.z;
  const std::string name = std::string(station.material) + "/";
  return {peg(name + "above", {board_x, off, z}, {level_tip, off, z}),
          peg(name + "below", {board_x, -off, z}, {level_tip, -off, z}),
          peg(name + "left", {board_x, 0.0, z}, {-station.room, 0.0, z}),
          peg(name + "right", {off, floor_y, z}, {off, right_top, z})};
}

// A plain peg with a round end; `collar` (m): how far a bead at its foot stands out.
Solid shape(double length, double collar, double collar_height) {
  std::vector<RadiusHeight> profile;
  const double from = foot;
  profile.push_back({peg_radius + collar, 0.0});
  profile.push_back({peg_radius + collar, from + 0.7 * collar_height});
  profile.push_back({peg_radius + 0.75 * collar, from + 0.92 * collar_height});
  profile.push_back({peg_radius, from + collar_height});
  const double straight = length - peg_radius;
  for (double z = from + collar_height + 2.0 * mm; z < straight - 1.0 * mm; z += 2.0 * mm)
    profile.push_back({peg_radius, z});
  for (int k = 0; k < 9; ++k) {
    const double angle = 0.5 * pi * k / 8.15;
    profile.push_back({peg_radius * math::cos(angle), straight + peg_radius * math::sin(angle)});
  }
  return lathe(profile, columns);
}

Model pegs(const std::string& name, const Material& material, const std::vector<Peg>& all, double collar,
           double collar_height) {
  Model model{.name = name, .materials = {material}, .parts = {}};
  for (const Peg& each : all) {
    model.parts.push_back({.name = each.name,
                           .material = 0,
                           .solid = transformed(shape(each.length, collar, collar_height), each.X_WP)});
  }
  return model;
}

}  // namespace

Model make_steel_pegs() {
  std::vector<Peg> all = at_station(stations_of_bar[2]);
  int number = 0;
  for (const double z : row_z)
    all.push_back(peg("steel/row/" + std::to_string(++number), {row_x, floor_y, z}, {row_x, row_top, z}));
  return pegs("pegs_steel",
              {.name = "steel peg", .base_colour = {0.64, 0.64, 0.65}, .metallic = 1.0, .roughness = 0.4},
              all, 4.0 * mm, 3.0 * mm);
}

Model make_wooden_pegs() {
  Model model = pegs(
      "pegs_wood", {.name = "wooden peg", .base_colour = {1.0, 1.0, 1.0}, .metallic = 0.0, .roughness = 0.5},
      at_station(stations_of_bar[1]), 2.5 * mm, 8.0 * mm);
  std::size_t i = 0;
  for (const Peg& each : at_station(stations_of_bar[1])) {
    Part& part = model.parts[i++];
    part.coat = grained(transformed(part.solid, each.X_WP.inverse()), beech);
  }
  return model;
}

Model make_rubber_pegs() {
  return pegs("pegs_rubber",
              {.name = "rubber peg", .base_colour = {0.30, 0.035, 0.02}, .metallic = 0.0, .roughness = 0.72},
              at_station(stations_of_bar[0]), 3.0 * mm, 14.0 * mm);
}

Model make_boards() {
  Model model{
      .name = "boards",
      .materials = {{.name = "foot", .base_colour = {0.02, 0.02, 0.02}, .metallic = 0.0, .roughness = 0.8}},
      .parts = {}};
  const auto add = [&](const char* name, const Vector3d& half, const Wood& wood, const Vector3d& p) {
    add_board(&model, {name, half, wood, 0.45}, Eigen::Isometry3d(Eigen::Translation3d(p)));
  };
  const Vector3d lying(132 * mm, 9 * mm, 142 * mm);
  const Vector3d upright(7 * mm, 96 * mm, 132 * mm);
  const Vector3d lying_middle(-6 * mm, floor_y - lying.y(), -166 * mm);
  add("lying", lying, oak, lying_middle);
  add("upright", upright, beech, {board_x - upright.x(), floor_y - 4 * mm + upright.y(), -166 * mm});
  constexpr RadiusHeight pad[] = {{9 * mm, 0.0}, {10 * mm, 1 * mm}, {10 * mm, 5 * mm}, {9 * mm, 6 * mm}};
  int number = 0;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      const Vector3d at(lying_middle.x() + x * (lying.x() - 20 * mm), bench_height,
                        lying_middle.z() + z * (lying.z() - 20 * mm));
      model.parts.push_back({.name = "foot/" + std::to_string(++number),
                             .material = 0,
                             .solid = transformed(lathe(pad, 32), frame_along(at, Vector3d::UnitY()))});
    }
  }
  return model;
}

}  // namespace fulcrum::content
