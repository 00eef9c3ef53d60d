#include "tools/content/piping/plant.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/content/mesh/steel.h"

namespace fulcrum::content {
namespace {

constexpr double steel_size = 34.0 * mm;  // of the picture of turned steel

}  // namespace

Plant::Plant() {
  model_.name = "piping";
  // In the order of Finish. Colours after RAL 6011 (water), RAL 1024 (gas) and RAL 7016 (frames), linear.
  model_.materials = {
      painted("paint, water green", {0.085, 0.19, 0.12}),
      painted("paint, gas ochre", {0.50, 0.28, 0.045}),
      {"galvanised steel", {0.50, 0.52, 0.54}, 1.0, 0.48},
      brushed("bare steel", {0.46, 0.45, 0.43}, 0.36),
      {"dark zinc", {0.20, 0.20, 0.21}, 1.0, 0.38},
      {"gasket", {0.16, 0.045, 0.03}, 0.0, 0.9},
      {"paint, frame grey", {0.055, 0.065, 0.075}, 0.0, 0.55},
      {"paint, hand-wheel red", {0.36, 0.022, 0.018}, 0.0, 0.4},
      {"brass", {0.60, 0.42, 0.15}, 1.0, 0.3},
      {"dial white", {0.82, 0.82, 0.79}, 0.0, 0.6},
      {"black", {0.015, 0.015, 0.017}, 0.0, 0.5},
  };
}

void Plant::add(std::string name, Finish finish, Solid solid) {
  model_.parts.push_back(
      {std::move(name), static_cast<std::size_t>(finish), std::move(solid), default_crease});
}

void Plant::add(std::string name, Finish finish, const Eigen::Isometry3d& X_WS, Solid solid) {
  add(std::move(name), finish, transformed(std::move(solid), X_WS));
}

void Plant::add_round(std::string name, Finish finish, const Eigen::Isometry3d& X_WS, Solid solid,
                      int columns, double radius, double first) {
  const double around = 2.0 * pi * radius;
  const bool is_painted = finish == Finish::water_paint || finish == Finish::gas_paint;
  // Paint once round, and twice as high as wide; lines of steel as close on a small part as on a large one.
  const Tiling tiling =
      is_painted ? Tiling{1, 2.0 * around, first}
                 : Tiling{std::max(1, static_cast<int>(std::lround(around / steel_size))), steel_size, first};
  CornerUv uv = unwrapped_sections(solid, columns, tiling);
  model_.parts.push_back({.name = std::move(name),
                          .material = static_cast<std::size_t>(finish),
                          .solid = transformed(std::move(solid), X_WS),
                          .uv = std::move(uv)});
}

std::string two_digits(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

}  // namespace fulcrum::content
