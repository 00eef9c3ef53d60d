#pragma once
// What the board of a strip says by USB, as bytes: docs/strip.md has them one by one. 64 bytes without a
// number, low byte first, a thousand times a second.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/hid/hid_id.h"

namespace fulcrum::strip {

// pid.codes keeps this number for what is built and tried at one's own desk. Others may have it, too: a
// strip's name says that it is one.
inline constexpr hid::HidId kIds[] = {{0x1209, 0x0001}};
inline std::span<const hid::HidId> usb_ids() {
  return kIds;
}
inline constexpr std::string_view kProduct = "Fulcrum strip";

inline constexpr std::size_t kReportBytes = 64;

struct StripSays {
  std::uint32_t number = 0;   // of the report; one more in each, and 0 after the last
  std::uint32_t time_us = 0;  // of the board's clock when the strip was read; runs over, too
  double ohm = 0;             // kStripOpen: nothing presses; kNoStrip: the board does not trust what it read
};
// None: it is no such report.
std::optional<StripSays> decode(std::span<const std::uint8_t> report);

// The strip was read anew between two reports, whatever was lost of those between.
bool follows(const StripSays& before, const StripSays& after);

}  // namespace fulcrum::strip
