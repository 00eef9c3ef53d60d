#pragma once
// How far a cap, sticks or keys are pushed: a device that a hand holds in place of a handle.

#include <cmath>
#include <cstdint>

#include "haptics/math/linear.h"

namespace fulcrum {

struct PushedAxes {
  Vec3 way = Vec3::Zero();   // (3) each from -1 to 1: right, up, toward the person
  Vec3 turn = Vec3::Zero();  // (3) each from -1 to 1: right-handed about the same axes
  std::uint32_t buttons = 0;

  bool rests() const { return way.isZero(0) && turn.isZero(0); }
};

// A part of a stick's way, -1 to 1, of which the first `rests` counts as let go: worn ones do not come back
// to the middle. Exactly 0 there, and 1 at the end.
inline double beyond_rest(double part, double rests) {
  const double beyond = std::abs(part) - rests;
  return beyond > 0 ? std::copysign(beyond / (1 - rests), part) : 0;
}

}  // namespace fulcrum
