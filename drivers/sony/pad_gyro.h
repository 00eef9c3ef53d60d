#pragma once
// A pad's gyroscope: how fast the pad is turned about right, up and toward the person, as it is held. Of both
// pads 2000 deg/s are the whole of 16 bits; what one is off by is learnt while the pad lies still.

#include <array>
#include <cstdint>

#include "haptics/math/linear.h"

namespace fulcrum::sony {

class PadGyro {
public:
  // (3) rad/s, of the readings of one report. in_use: the pad is turned on purpose, however slowly.
  Vec3 rate(const std::array<std::int16_t, 3>& readings, bool in_use) noexcept;

private:
  Vec3 off_ = Vec3::Zero();  // (3) rad/s, at rest
  int still_ = 0;            // reports, one after another
};

}  // namespace fulcrum::sony
