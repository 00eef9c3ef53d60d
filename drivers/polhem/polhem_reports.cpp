#include "drivers/polhem/polhem_reports.h"

#include <algorithm>

namespace fulcrum::polhem {
namespace {

using Numbers = std::array<int, 7>;

// The firmware adds this to the count of the gimbal's last encoder while the stylus's button is down.
constexpr int kButtonDown = 10000, kButtonFrom = 5000;
constexpr int kCalibrate = 1;  // a command; 0: currents

BoardHears bytes_of(const Numbers& numbers) {
  BoardHears bytes{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto word = static_cast<std::uint16_t>(std::clamp(numbers[i], -32768, 32767));
    bytes[1 + 2 * i] = static_cast<std::uint8_t>(word & 0xffu);
    bytes[2 + 2 * i] = static_cast<std::uint8_t>(word >> 8);
  }
  return bytes;
}

}  // namespace

std::optional<BoardSays> decode(std::span<const std::uint8_t> report) {
  if (report.size() != kReportBytes) return std::nullopt;
  Numbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] =
        static_cast<std::int16_t>(static_cast<std::uint16_t>(report[2 * i] | report[2 * i + 1] << 8));
  BoardSays says;
  std::copy_n(numbers.begin(), says.counts.size(), says.counts.begin());
  says.button = says.counts[3] > kButtonFrom;
  if (says.button) says.counts[3] -= kButtonDown;
  says.asks_calibration = numbers[6] == 1;
  return says;
}

BoardHears encode_currents(const std::array<int, 3>& mA) {
  return bytes_of({mA[0], mA[1], mA[2], 0, 0, 0, 0});
}

BoardHears encode_calibration(const std::array<int, 6>& counts) {
  return bytes_of({counts[3], counts[4], counts[5], kCalibrate, counts[0], counts[1], counts[2]});
}

}  // namespace fulcrum::polhem
