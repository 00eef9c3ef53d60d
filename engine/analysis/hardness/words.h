#pragma once
// Figures in a hardness study's sentences and tables.

#include <cmath>
#include <string>

#include "engine/report/axis.h"

namespace fulcrum::analysis::hardness {

inline std::string number(double value) {
  constexpr double nothing = 1e-9;  // what rounding leaves
  return std::abs(value) < nothing ? "0" : report::short_number(value, 3);
}

inline std::string percent(double part) {
  return number(std::round(100 * part)) + " %";
}

}  // namespace fulcrum::analysis::hardness
