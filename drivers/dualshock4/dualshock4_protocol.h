#pragma once
// Sony's DualShock 4, by USB or Bluetooth. Facts of the reports from Linux's hid-playstation.c.

#include <span>

#include "drivers/hid/hid_id.h"
#include "drivers/hid/hid_protocol.h"
#include "drivers/sony/pad_gyro.h"
#include "drivers/sony/sony_reports.h"

namespace fulcrum::dualshock4 {

class DualShock4Protocol final : public hid::HidProtocol {
public:
  explicit DualShock4Protocol(sony::Link link) : link_(link) {}

  bool decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept override;
  // Two rumble motors: left is the heavy one.
  std::size_t encode(const ChannelDrives& drives, Report& report) noexcept override;
  // On Bluetooth its calibration, after which it sends all that it has.
  std::span<const Feature> features() const noexcept override;
  bool streams() const noexcept override { return true; }

private:
  sony::Link link_;
  sony::PadGyro gyro_;
};

std::span<const hid::HidId> usb_ids();

}  // namespace fulcrum::dualshock4
