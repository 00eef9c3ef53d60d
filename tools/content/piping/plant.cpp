#include "tools/content/piping/plant.h"

#include <utility>

namespace fulcrum::content {

Plant::Plant() {
  model_.name = "piping";
  // In the order of Finish. Colours after RAL 6011 (water), RAL 1024 (gas) and RAL 7016 (frames), linear.
  model_.materials = {
      {"paint, water green", {0.085, 0.19, 0.12}, 0.0, 0.42},
      {"paint, gas ochre", {0.50, 0.28, 0.045}, 0.0, 0.42},
      {"galvanised steel", {0.50, 0.52, 0.54}, 1.0, 0.48},
      {"bare steel", {0.42, 0.41, 0.39}, 1.0, 0.34},
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

std::string two_digits(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

}  // namespace fulcrum::content
