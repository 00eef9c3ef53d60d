#include "drivers/dualsense/dualsense_protocol.h"

#include <algorithm>

#include "drivers/hid/hid_bytes.h"
#include "drivers/sony/pad_axes.h"
#include "drivers/sony/sony_reports.h"

namespace fulcrum::dualsense {
namespace {

constexpr std::uint8_t kUsbIn = 0x01, kUsbOut = 0x02, kBluetooth = 0x31;
constexpr std::size_t kUsbOutLength = 63;
constexpr std::uint8_t kMotors = 0x02;                         // flags 0: the motors are no voice coils now
constexpr std::uint8_t kRumble = 0x01;                         // flags 0: and rumble, as old firmware has it
constexpr std::uint8_t kNewerRumble = 0x04;                    // flags 2: as firmware from kNewer on has it
constexpr std::uint8_t kFirmware = 0x20, kCalibration = 0x05;  // feature reports
constexpr std::size_t kVersionAt = 44;
constexpr std::uint16_t kNewer = 0x0215;
constexpr std::uint8_t kBluetoothTag = 0x10;
constexpr std::size_t kGyroAt = 15;  // from the sticks on

// x: the first byte of the sticks.
sony::Pad pad_of(std::span<const std::uint8_t> x) {
  const std::uint32_t keys =
      x[7] | static_cast<std::uint32_t>(x[8]) << 8 | static_cast<std::uint32_t>(x[9]) << 16;
  return {x[0], x[1], x[2], x[3], x[4], x[5], keys & 0x3FFFF, sony::gyro_at(x, kGyroAt)};
}

}  // namespace

bool DualSenseProtocol::decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept {
  if (report.size() == sony::kUsbInput && report[0] == kUsbIn && link_ == sony::Link::usb) {
    axes = sony::axes_of(pad_of(report.subspan(1)), gyro_);
    return true;
  }
  if (report.size() == sony::kBluetoothReport && report[0] == kBluetooth && sony::whole_input(report)) {
    axes = sony::axes_of(pad_of(report.subspan(2)), gyro_);
    return true;
  }
  return false;  // also the reduced report, which has no counter: the first feature report ends those
}

std::span<const hid::HidProtocol::Feature> DualSenseProtocol::features() const noexcept {
  static constexpr Feature all[] = {{kFirmware, 64}, {kCalibration, 41}};
  return std::span(all).first(link_ == sony::Link::bluetooth ? 2 : 1);
}

void DualSenseProtocol::learn(std::span<const std::uint8_t> feature) noexcept {
  if (feature.size() >= kVersionAt + 2 && feature[0] == kFirmware)
    newer_rumble_ = hid::u16_at(feature, kVersionAt) >= kNewer;
}

std::size_t DualSenseProtocol::encode(const ChannelDrives& drives, Report& report) noexcept {
  std::ranges::fill(report, std::uint8_t{0});
  const bool usb = link_ == sony::Link::usb;
  const std::size_t flags = usb ? 1 : 3;  // where what both have begins
  report[flags] = newer_rumble_ ? kMotors : kMotors | kRumble;
  report[flags + 2] = sony::motor_byte(drives[1]);
  report[flags + 3] = sony::motor_byte(drives[0]);
  if (newer_rumble_) report[flags + 38] = kNewerRumble;
  if (usb) {
    report[0] = kUsbOut;
    return kUsbOutLength;
  }
  report[0] = kBluetooth;
  report[1] = static_cast<std::uint8_t>(sequence_ << 4);
  report[2] = kBluetoothTag;
  sequence_ = (sequence_ + 1) & 0x0F;
  sony::seal_output(std::span(report).first(sony::kBluetoothReport));
  return sony::kBluetoothReport;
}

std::span<const hid::HidId> usb_ids() {
  static constexpr hid::HidId ids[] = {{0x054c, 0x0ce6}, {0x054c, 0x0df2}};  // the Edge, too
  return ids;
}

}  // namespace fulcrum::dualsense
