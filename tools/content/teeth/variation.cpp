#include "tools/content/teeth/variation.h"

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

double Variations::within(double most) {
  constexpr double range = 4294967295.0;
  return most * (2.0 * static_cast<double>(random_()) / range - 1.0);
}

Variation Variations::next() {
  Variation own;
  own.size = 1.0 + within(0.016);
  own.turn = within(3.0 * degree);
  own.inward = within(1.5 * degree);
  own.mesial = within(1.2 * degree);
  own.outward = within(0.22);
  own.up = within(0.16);
  own.phase = within(0.8);
  return own;
}

}  // namespace fulcrum::content
