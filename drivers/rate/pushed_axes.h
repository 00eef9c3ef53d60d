#pragma once
// How far a cap, sticks or keys are pushed: a device that a hand holds in place of a handle.

#include <cstdint>

#include "haptics/math/linear.h"

namespace fulcrum {

struct PushedAxes {
  Vec3 way = Vec3::Zero();   // (3) each from -1 to 1: right, up, toward the person
  Vec3 turn = Vec3::Zero();  // (3) each from -1 to 1: right-handed about the same axes
  std::uint32_t buttons = 0;

  bool rests() const { return way.isZero(0) && turn.isZero(0); }
};

}  // namespace fulcrum
