#include "drivers/joycon/joycon_stick.h"

#include <algorithm>

#include "drivers/rate/pushed_axes.h"

namespace fulcrum::joycon {
namespace {

constexpr double kStickRests = 0.15;  // of its way, as its maker has it
constexpr int kShortestWay = 300;     // of a stick that can be pushed
constexpr int kLargestReading = 4095;

bool plausible(const StickAxis& axis) {
  return std::min(axis.above, axis.below) >= kShortestWay && axis.middle >= axis.below &&
         axis.middle + axis.above <= kLargestReading;
}

}  // namespace

std::array<int, 2> readings_in(std::span<const std::uint8_t, 3> bytes) {
  return {bytes[0] | (bytes[1] & 0x0F) << 8, bytes[1] >> 4 | bytes[2] << 4};
}

void calibrate(Stick& stick, std::span<const std::uint8_t, 9> bytes, Side side) {
  const std::array<std::array<int, 2>, 3> said{readings_in(bytes.subspan<0, 3>()),
                                               readings_in(bytes.subspan<3, 3>()),
                                               readings_in(bytes.subspan<6, 3>())};
  const std::size_t first = side == Side::left ? 1 : 0;  // where the middle stands
  Stick measured;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    measured[i] = {.middle = said[first][i], .above = said[(first + 2) % 3][i], .below = said[first + 1][i]};
    if (!plausible(measured[i])) return;
  }
  stick = measured;
}

std::array<double, 2> pushed(const Stick& stick, std::span<const std::uint8_t, 3> bytes) {
  const std::array<int, 2> readings = readings_in(bytes);
  std::array<double, 2> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int off = readings[i] - stick[i].middle;
    const double part = static_cast<double>(off) / (off > 0 ? stick[i].above : stick[i].below);
    parts[i] = beyond_rest(std::clamp(part, -1.0, 1.0), kStickRests);
  }
  return parts;
}

}  // namespace fulcrum::joycon
