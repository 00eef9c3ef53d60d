#pragma once
// Sony's DualSense, by USB or Bluetooth. Facts of the reports from Linux's hid-playstation.c.
//
// Of both, after the report's number (on Bluetooth after one byte more): sticks, triggers, a counter, keys.
// On Bluetooth a CRC-32 ends each report, and all of it comes only after a feature report was read.

#include <span>

#include "drivers/hid/hid_id.h"
#include "drivers/hid/hid_protocol.h"
#include "drivers/sony/pad_gyro.h"
#include "drivers/sony/sony_reports.h"

namespace fulcrum::dualsense {

class DualSenseProtocol final : public hid::HidProtocol {
public:
  explicit DualSenseProtocol(sony::Link link) : link_(link) {}

  bool decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept override;
  // Two rumble motors: left is the heavy one.
  std::size_t encode(const ChannelDrives& drives, Report& report) noexcept override;
  // Its firmware's version, which says how it wants to be told of rumble; on Bluetooth its calibration, after
  // which it sends all that it has.
  std::span<const Feature> features() const noexcept override;
  void learn(std::span<const std::uint8_t> feature) noexcept override;
  bool streams() const noexcept override { return true; }

private:
  sony::Link link_;
  sony::PadGyro gyro_;
  bool newer_rumble_ = false;
  std::uint8_t sequence_ = 0;  // of reports that were sent by Bluetooth, 0 to 15
};

std::span<const hid::HidId> usb_ids();

}  // namespace fulcrum::dualsense
