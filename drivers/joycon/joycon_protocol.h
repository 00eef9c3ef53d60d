#pragma once
// A Joy-Con by Bluetooth, and the Pro Controller, which says the same of both halves. Facts of the reports
// from "Nintendo Switch Reverse Engineering" (bluetooth_hid_notes.md, spi_flash_notes.md) and Linux's
// hid-nintendo.c.
//
//     in   0x30, 0x21   the state: three bytes of keys, three of each stick; 0x21 with an answer behind it
//     out  0x10         a count, then four bytes for the actuator of each half
//     out  0x01         the same, and a question or an order
//
// Woken, it says only which key was pressed (0x3F). It is told to say all, to vibrate and to show a light,
// and asked for its sticks' calibration, each until it has answered. Too many reports make it drop its
// Bluetooth connection; so they go slowly.

#include <array>
#include <atomic>
#include <cstdint>
#include <span>

#include "drivers/hid/hid_id.h"
#include "drivers/hid/hid_protocol.h"
#include "drivers/joycon/joycon_stick.h"

namespace fulcrum::joycon {

// Of DeviceSample::buttons, which are the keys in the order of the report: Y, X, B, A, SR, SL, R, ZR; minus,
// plus, right stick, left stick, home, capture; from bit 16 on down, up, right, left, SR, SL, L, ZL.
inline constexpr std::uint32_t kMinus = 1U << 8, kPlus = 1U << 9;

class JoyConProtocol final : public hid::HidProtocol {
public:
  // carrier_Hz: of what its channels, left and right, are to render.
  JoyConProtocol(Side side, double carrier_Hz) : side_(side), carrier_Hz_(carrier_Hz) {}

  // Of one half its own axes alone: what both say adds up to all six.
  //     left stick    way right and up           right stick    turn about up and right
  //     ZR, ZL        way away from the person, and back
  //     R, L          turn about the line of sight, clockwise and back
  bool decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept override;
  std::size_t encode(const ChannelDrives& drives, Report& report) noexcept override;
  std::size_t ask(Report& report) noexcept override;
  // Half of what Linux's own driver leaves between two on Bluetooth, so that a level is not told later than
  // an actuator follows.
  Pace pace() const noexcept override { return {.write_ms = 30, .repeat_ms = 60}; }
  bool streams() const noexcept override { return true; }

private:
  void hear(std::span<const std::uint8_t> report) noexcept;
  std::size_t begin(std::uint8_t number, Report& report) noexcept;

  Side side_;
  double carrier_Hz_;
  Stick left_, right_;                      // of the thread that decodes
  std::atomic<std::uint32_t> answered_{0};  // bit n: of question n
  std::array<std::uint8_t, 8> actuators_{0x00, 0x01, 0x40, 0x40, 0x00, 0x01, 0x40, 0x40};  // as last told
  std::uint8_t count_ = 0;  // of reports that were sent, 0 to 15
  bool asked_ = false;      // in the turn before
};

std::span<const hid::HidId> ids(Side side);  // both: the Pro Controller's
std::span<const hid::HidId> pair_ids();

}  // namespace fulcrum::joycon
