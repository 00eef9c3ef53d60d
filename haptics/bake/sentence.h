#pragma once
// How the bake's sentences spell numbers.

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

inline std::string spell(const Vec3& p) {
  std::string text = "(";
  return text.append(spell(p.x()))
      .append(", ")
      .append(spell(p.y()))
      .append(", ")
      .append(spell(p.z()))
      .append(") m");
}

inline std::string spell_mm(double metres) {
  return spell(metres * 1e3) + " mm";
}

}  // namespace fulcrum
