#pragma once
// A Joy-Con's stick: two readings of 12 bits, and what its maker or its owner measured of it.

#include <array>
#include <cstdint>
#include <span>

namespace fulcrum::joycon {

enum class Side { left, right, both };  // the halves of a pair; a Pro Controller has both sticks

// Of one axis, as readings.
struct StickAxis {
  int middle = 2048;
  int above = 1200, below = 1200;  // from the middle to either end
};
using Stick = std::array<StickAxis, 2>;  // right, up

// Two readings of 12 bits in three bytes.
std::array<int, 2> readings_in(std::span<const std::uint8_t, 3> bytes);

// Takes the nine bytes of a calibration; leaves the stick as it is where they are none, such as flash that
// was never written. Of a left stick they are above, middle, below, of a right one middle, below, above.
void calibrate(Stick& stick, std::span<const std::uint8_t, 9> bytes, Side side);

// (2) -1 to 1, right and up; exactly 0 where the stick rests.
std::array<double, 2> pushed(const Stick& stick, std::span<const std::uint8_t, 3> bytes);

}  // namespace fulcrum::joycon
