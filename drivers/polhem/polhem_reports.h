#pragma once
// What a Polhem's board says and is told by USB, as bytes: seven 16-bit numbers each way, low byte first,
// without a number of the report. Source: the open firmware of haptikfabrikenapi, firmware/main.cpp.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/hid/hid_id.h"

namespace fulcrum::polhem {

inline constexpr hid::HidId kIds[] = {{0x1234, 0x0006}};
inline std::span<const hid::HidId> usb_ids() {
  return kIds;
}

inline constexpr std::size_t kReportBytes = 14;

struct BoardSays {
  std::array<int, 6> counts{};    // of the encoders: yaw, shoulder, elbow; last of the gimbal to its first
  bool asks_calibration = false;  // the button on the board was pressed: the arm is in its place
  bool button = false;            // of the stylus
};
// None: it is not such a report.
std::optional<BoardSays> decode(std::span<const std::uint8_t> report);

// As hid_write takes it: a zero before the report.
using BoardHears = std::array<std::uint8_t, kReportBytes + 1>;
BoardHears encode_currents(const std::array<int, 3>& mA);
// The counts are these from here on.
BoardHears encode_calibration(const std::array<int, 6>& counts);

}  // namespace fulcrum::polhem
