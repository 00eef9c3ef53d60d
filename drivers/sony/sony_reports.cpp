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

std::uint8_t motor_byte(double drive) {
  if (!(drive > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(255 * std::fmin(drive, 1.0)));
}

}  // namespace fulcrum::sony
