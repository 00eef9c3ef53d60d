#pragma once
// What a Joy-Con's actuator is told: a frequency and an amplitude in each of two bands, four bytes in all.
// Facts of the encoding, and where an actuator comes to harm, from "Nintendo Switch Reverse Engineering"
// (bluetooth_hid_notes.md, rumble_data_table.md).
//
//     n = 32 log2(f / 10 Hz)                          low band 41 to 626 Hz, high band 82 to 1253 Hz
//     a = 32 log2(8.7 A)     for A > .2275
//         16 log2(17 A)      for A > .115
//         4 log2(120 A)      below, at least 1
//
//     bytes: 4 (n - 0x60), 9 bits, with 2 a in the upper 7 of the second; n - 0x40 and 0x40 + a / 2, with the
//     half of an odd a above n

#include <array>
#include <cstdint>

namespace fulcrum::joycon {

using RumbleBytes = std::array<std::uint8_t, 4>;  // high band, low band

// No amplitude, at the middles of the bands, 320 and 160 Hz.
inline constexpr RumbleBytes kRumbleRests{0x00, 0x01, 0x40, 0x40};

// A tone in the band whose middle is nearer to it; the other band rests. frequency_Hz: what is beyond the
// bands becomes their end. amplitude: 0 to 1, what is beyond is 1, what is no number 0. An amplitude of 1 is
// the largest that does no harm.
RumbleBytes rumble_of(double frequency_Hz, double amplitude);

}  // namespace fulcrum::joycon
