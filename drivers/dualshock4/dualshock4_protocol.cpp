#include "drivers/dualshock4/dualshock4_protocol.h"

#include <algorithm>

#include "drivers/sony/pad_axes.h"
#include "drivers/sony/sony_reports.h"

namespace fulcrum::dualshock4 {
namespace {

constexpr std::uint8_t kUsbIn = 0x01, kUsbOut = 0x05, kBluetooth = 0x11;
constexpr std::size_t kUsbOutLength = 32;
constexpr std::uint8_t kMotors = 0x01;           // flags
constexpr std::uint8_t kHidWithChecksum = 0xC0;  // how a Bluetooth report is to be read
constexpr std::size_t kGyroAt = 12;              // from the sticks on

// x: the first byte of the sticks. The last byte of keys counts reports in its upper bits.
sony::Pad pad_of(std::span<const std::uint8_t> x) {
  const std::uint32_t keys =
      x[4] | static_cast<std::uint32_t>(x[5]) << 8 | static_cast<std::uint32_t>(x[6]) << 16;
  return {x[0], x[1], x[2], x[3], x[7], x[8], keys & 0x3FFFF, sony::gyro_at(x, kGyroAt)};
}

}  // namespace

bool DualShock4Protocol::decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept {
  if (report.size() == sony::kUsbInput && report[0] == kUsbIn && link_ == sony::Link::usb) {
    axes = sony::axes_of(pad_of(report.subspan(1)), gyro_);
    return true;
  }
  if (report.size() == sony::kBluetoothReport && report[0] == kBluetooth && sony::whole_input(report)) {
    axes = sony::axes_of(pad_of(report.subspan(3)), gyro_);
    return true;
  }
  return false;
}

std::span<const hid::HidProtocol::Feature> DualShock4Protocol::features() const noexcept {
  static constexpr Feature calibration[] = {{0x05, 41}};
  return std::span(calibration).first(link_ == sony::Link::bluetooth ? 1 : 0);
}

std::size_t DualShock4Protocol::encode(const ChannelDrives& drives, Report& report) noexcept {
  std::ranges::fill(report, std::uint8_t{0});
  const bool usb = link_ == sony::Link::usb;
  const std::size_t flags = usb ? 1 : 3;
  report[flags] = kMotors;
  report[flags + 3] = sony::motor_byte(drives[1]);
  report[flags + 4] = sony::motor_byte(drives[0]);
  if (usb) {
    report[0] = kUsbOut;
    return kUsbOutLength;
  }
  report[0] = kBluetooth;
  report[1] = kHidWithChecksum;
  sony::seal_output(std::span(report).first(sony::kBluetoothReport));
  return sony::kBluetoothReport;
}

std::span<const hid::HidId> usb_ids() {
  static constexpr hid::HidId ids[] = {
      {0x054c, 0x05c4}, {0x054c, 0x09cc}, {0x054c, 0x0ba0}};  // the last: their USB stick
  return ids;
}

}  // namespace fulcrum::dualshock4
