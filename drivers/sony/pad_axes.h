#pragma once
// How a pad's sticks and triggers stand for the six axes of a tool. Both of Sony's pads have the same ones.
//
//     left stick    way right and up           right stick    turn about up and right
//     R2, L2        way away from the person, and back
//     R1, L1        turn about the line of sight, clockwise and back
//     touchpad      while it is pressed, the pad's own turn in place of stick and buttons

#include <array>
#include <cstdint>

#include "drivers/rate/pushed_axes.h"
#include "drivers/sony/pad_gyro.h"

namespace fulcrum::sony {

struct Pad {
  std::uint8_t left_x = 128, left_y = 128, right_x = 128, right_y = 128;  // 0 left or up, 128 let go
  std::uint8_t l2 = 0, r2 = 0;                                            // 255: pulled through
  // Of both pads in this order: 4 bits of the cross (8: let go), square, cross, circle, triangle, L1, R1, L2,
  // R2, share or create, options, L3, R3, PS, touchpad.
  std::uint32_t keys = 8;
  std::array<std::int16_t, 3> gyro{};  // about right, up, toward the person
};

// gyro: of this pad; it learns from each report. Of DeviceSample::buttons: the keys without the cross, square
// first.
PushedAxes axes_of(const Pad& pad, PadGyro& gyro);
inline constexpr std::uint32_t kShare = 1U << 8,
                               kOptions = 1U << 9;  // the DualSense's share is called create

}  // namespace fulcrum::sony
