#include "drivers/sony/sony_reports.h"

#include <cmath>

#include "drivers/hid/hid_bytes.h"

namespace fulcrum::sony {
namespace {

constexpr std::uint8_t kInputSeed = 0xA1, kOutputSeed = 0xA2;
constexpr std::size_t kSummed = kBluetoothReport - 4;

}  // namespace

bool whole_input(std::span<const std::uint8_t> report) {
  return report.size() >= kBluetoothReport &&
         hid::crc32(kInputSeed, report.first(kSummed)) == hid::u32_at(report, kSummed);
}

void seal_output(std::span<std::uint8_t> report) {
  hid::put_u32(report, kSummed, hid::crc32(kOutputSeed, report.first(kSummed)));
}

std::array<std::int16_t, 3> gyro_at(std::span<const std::uint8_t> sticks, std::size_t at) {
  return {hid::i16_at(sticks, at), hid::i16_at(sticks, at + 2), hid::i16_at(sticks, at + 4)};
}

std::uint8_t motor_byte(double drive) {
  if (!(drive > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(255 * std::fmin(drive, 1.0)));
}

}  // namespace fulcrum::sony
