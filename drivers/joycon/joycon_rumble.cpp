#include "drivers/joycon/joycon_rumble.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum::joycon {
namespace {

constexpr double kLowest_Hz = 41, kHighest_Hz = 1252;
constexpr int kBetween = 0x90;  // as n: 226 Hz, as far from 160 Hz as from 320 Hz
// Where the steps of the amplitude grow: between rows of the table.
constexpr double kLoud = 0.2275, kFaint = 0.115;
constexpr double kFaintest = 4e-3;   // an amplitude below which nothing vibrates
constexpr int kMostAmplitude = 100;  // as a: bytes 0xC8 and 0x72, above which actuators come to harm

double log2(double x) {
  return math::log(x) / std::numbers::ln2;
}

int frequency_number(double frequency_Hz) {
  const double within = std::fmin(std::fmax(frequency_Hz, kLowest_Hz), kHighest_Hz);
  return static_cast<int>(std::lround(32 * log2(within / 10)));
}

int amplitude_number(double amplitude) {
  if (!(amplitude > kFaintest)) return 0;
  const double within = std::fmin(amplitude, 1.0);
  const double number = within > kLoud    ? 32 * log2(8.7 * within)
                        : within > kFaint ? 16 * log2(17 * within)
                                          : 4 * log2(120 * within);
  return std::clamp(static_cast<int>(std::lround(number)), 1, kMostAmplitude);
}

}  // namespace

RumbleBytes rumble_of(double frequency_Hz, double amplitude) {
  RumbleBytes bytes = kRumbleRests;
  const int n = frequency_number(frequency_Hz), a = amplitude_number(amplitude);
  if (a == 0) return bytes;
  if (n > kBetween) {
    const int frequency = 4 * (n - 0x60);
    bytes[0] = static_cast<std::uint8_t>(frequency & 0xFF);
    bytes[1] = static_cast<std::uint8_t>(2 * a | frequency >> 8);
  } else {
    bytes[2] = static_cast<std::uint8_t>((n - 0x40) | (a % 2 == 1 ? 0x80 : 0));
    bytes[3] = static_cast<std::uint8_t>(0x40 + a / 2);
  }
  return bytes;
}

}  // namespace fulcrum::joycon
