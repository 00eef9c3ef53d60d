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

  Model take() { return std::move(model_); }

private:
  Model model_;
};

// "07"
std::string two_digits(int number);

}  // namespace fulcrum::content
