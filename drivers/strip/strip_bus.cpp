#include "drivers/strip/strip_bus.h"

#include <array>

namespace fulcrum::strip {
namespace {

constexpr int kStripWait_ms = 5;
constexpr int kKept = 63;  // reports, by hidraw, which drops what is newer

}  // namespace

ForceBus::Turn StripBus::exchange(const DeviceCommand&, DeviceSample& sample) {
  std::array<std::uint8_t, 2 * kReportBytes> bytes{};
  std::optional<double> read_ohm;
  int count = 0;
  for (; count < kKept; ++count) {
    const int length = port_->read(bytes, count == 0 ? kStripWait_ms : 0);
    if (length < 0) return Turn::lost;
    if (length == 0) break;
    spoke_ = true;
    const std::optional<StripSays> says = decode(std::span(bytes).first(static_cast<std::size_t>(length)));
    if (!says) continue;
    if (last_ && follows(*last_, *says)) read_ohm = says->ohm;
    last_ = says;
  }
  if (!read_ohm || count == kKept) return Turn::none;  // so many are the oldest of what came
  sample.strip_ohm = *read_ohm;
  sample.age = 0;
  return Turn::fresh;
}

std::string StripBus::trouble() const {
  if (!spoke_) return {};
  return last_
             ? "it is plugged in, and repeats itself: neither the number of its reports nor their time goes "
               "on. Its firmware stands still; plug it in again."
             : "it is plugged in, and what it says is no strip's report: docs/strip.md has it byte by byte.";
}

}  // namespace fulcrum::strip
