#pragma once
// How the bake's sentences spell numbers.

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

#include "haptics/math/linear.h"

namespace fulcrum {

inline std::string spell(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << value;
  return text.str();
}

// A place to the nanometre: what is less is rounding.
inline std::string spell(const Vec3& p) {
  const auto coordinate = [&p](Eigen::Index axis) { return spell(std::round(p[axis] * 1e9) * 1e-9 + 0.0); };
  return "(" + coordinate(0) + ", " + coordinate(1) + ", " + coordinate(2) + ") m";
}

inline std::string spell_mm(double metres) {
  return spell(metres * 1e3) + " mm";
}

inline std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace fulcrum
