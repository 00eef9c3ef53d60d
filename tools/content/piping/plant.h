#pragma once

#include <string>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

enum class Finish : std::size_t {
  water_paint,
  gas_paint,
  galvanised,
  bare_steel,
  zinc,
  gasket,
  frame_paint,
  red_paint,
  brass,
  white,
  black,
};

// The plant while it is being put together.
class Plant {
public:
  Plant();

  void add(std::string name, Finish finish, Solid solid);
  void add(std::string name, Finish finish, const Eigen::Isometry3d& X_WS, Solid solid);
  // With a place in its finish's pictures: a solid through sections of `columns` points, of about that radius
  // (m), which begins at `first` of the picture.
  void add_round(std::string name, Finish finish, const Eigen::Isometry3d& X_WS, Solid solid, int columns,
                 double radius, double first = 0.0);

  Model take() { return std::move(model_); }

private:
  Model model_;
};

// "07"
std::string two_digits(int number);

}  // namespace fulcrum::content
