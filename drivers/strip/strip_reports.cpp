#include "drivers/strip/strip_reports.h"

#include <algorithm>
#include <array>

#include "drivers/hid/hid_bytes.h"
#include "haptics/device/holding_strip.h"

namespace fulcrum::strip {
namespace {

constexpr std::array<std::uint8_t, 4> kMark{'F', 'S', 'T', '1'};  // the 1 is the version
constexpr std::size_t kNumberAt = 4, kTimeAt = 8, kReadingAt = 12, kStateAt = 16;
constexpr std::uint32_t kOpen = 0xFFFFFFFF;
constexpr double kOhm = 0.1;              // of a step of the reading
constexpr std::uint32_t kDistrusted = 1;  // of the state

// Of a count that runs over: the shorter way round.
bool after(std::uint32_t before, std::uint32_t now) {
  return now != before && now - before < 0x80000000U;
}

double ohm_of(std::uint32_t reading, std::uint32_t state) {
  if ((state & kDistrusted) != 0) return kNoStrip;
  return reading == kOpen ? kStripOpen : kOhm * reading;
}

}  // namespace

std::optional<StripSays> decode(std::span<const std::uint8_t> report) {
  if (report.size() != kReportBytes || !std::ranges::equal(report.first(kMark.size()), kMark))
    return std::nullopt;
  return StripSays{hid::u32_at(report, kNumberAt), hid::u32_at(report, kTimeAt),
                   ohm_of(hid::u32_at(report, kReadingAt), hid::u32_at(report, kStateAt))};
}

bool follows(const StripSays& before, const StripSays& now) {
  return after(before.number, now.number) && after(before.time_us, now.time_us);
}

}  // namespace fulcrum::strip
