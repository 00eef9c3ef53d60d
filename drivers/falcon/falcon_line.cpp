#include "drivers/falcon/falcon_line.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace fulcrum::falcon {
namespace {

using Clock = std::chrono::steady_clock;

// Requests to an FTDI, as libftdi names them.
constexpr std::uint8_t kReset = 0, kModem = 1, kFlow = 2, kBaud = 3, kData = 4, kLatency = 9;
constexpr std::uint16_t kPurgeIn = 1, kPurgeOut = 2;
constexpr std::uint16_t kRtsLow = 0x200, kDtrLow = 0x100, kDtrHigh = 0x101;
constexpr std::uint16_t k9600 = 0x4138, k140000 = 0x15, kFastest = 2;
constexpr std::uint16_t k8N1 = 8;

}  // namespace

bool FalconLine::set(std::span<const Setting> settings) {
  return std::ranges::all_of(
      settings, [&](const Setting& s) { return port_.control(s.request, s.value); });
}

bool FalconLine::to_greet() {
  return set(std::array<Setting, 9>{{{kReset, kPurgeIn},
                                     {kReset, kPurgeOut},
                                     {kLatency, 16},
                                     {kBaud, k9600},
                                     {kData, k8N1},
                                     {kFlow, 0},
                                     {kModem, kRtsLow},
                                     {kModem, kDtrLow},
                                     {kModem, kDtrHigh}}});
}

bool FalconLine::to_load() {
  return set(std::array<Setting, 2>{{{kModem, kDtrLow}, {kBaud, k140000}}});
}

bool FalconLine::to_exchange() {
  return set(
      std::array<Setting, 4>{{{kLatency, 1}, {kBaud, kFastest}, {kReset, kPurgeIn}, {kReset, kPurgeOut}}});
}

int FalconLine::read(std::span<std::uint8_t> bytes, int wait_ms) {
  const auto due = Clock::now() + std::chrono::milliseconds(wait_ms);
  std::array<std::uint8_t, usb::kPacketBytes> packet{};
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - Clock::now()).count();
    const int length = port_.read(packet, static_cast<int>(std::max<std::int64_t>(left, 0)));
    if (length <= 0) return length;
    const auto line = std::span(packet).first(static_cast<std::size_t>(length));
    if (line.size() > 2) {
      const auto said = line.subspan(2);
      const std::size_t count = std::min(said.size(), bytes.size());
      std::copy_n(said.begin(), count, bytes.begin());
      return static_cast<int>(count);
    }
    if (left <= 0) return 0;
  }
}

}  // namespace fulcrum::falcon
