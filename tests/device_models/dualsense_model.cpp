#include "tests/device_models/dualsense_model.h"

#include <algorithm>
#include <utility>

namespace fulcrum::test {
namespace {

constexpr std::uint8_t kInputSeed = 0xA1, kFeatureSeed = 0xA3;

void append(Bytes& all, const Bytes& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// A report of the maker's own: so many bytes after its number. kind: 0x81 in, 0x91 out, 0xB1 feature.
Bytes own_report(std::uint8_t number, std::uint8_t usage, std::uint8_t bytes, std::uint8_t kind) {
  return {0x85, number, 0x09, usage, 0x75, 0x08, 0x95, bytes, kind, 0x02};
}

// Sticks, triggers, cross and 15 keys where games look for them; the rest of a report is the maker's own.
Bytes pad_descriptor(DualSenseModel::Bus bus) {
  Bytes all{0x05, 0x01, 0x09, 0x05, 0xA1, 0x01, 0x85, 0x01};  // generic desktop, game pad, application
  append(all, {0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x09, 0x35, 0x09, 0x33, 0x09, 0x34,  // X Y Z Rz Rx Ry
               0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x06, 0x81, 0x02});
  if (bus == DualSenseModel::Bus::usb)
    append(all, {0x06, 0x00, 0xFF, 0x09, 0x20, 0x95, 0x01, 0x81, 0x02});  // the counter
  append(all, {0x05, 0x01, 0x09, 0x39, 0x15, 0x00, 0x25, 0x07, 0x75, 0x04, 0x95, 0x01, 0x81, 0x42});  // cross
  append(all,
         {0x05, 0x09, 0x19, 0x01, 0x29, 0x0F, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x0F, 0x81, 0x02});
  append(all, {0x06, 0x00, 0xFF, 0x09, 0x21, 0x95, 0x0D, 0x81, 0x02});
  append(all, {0x15, 0x00, 0x26, 0xFF, 0x00});
  if (bus == DualSenseModel::Bus::usb) {
    append(all, {0x09, 0x22, 0x75, 0x08, 0x95, 0x34, 0x81, 0x02});
    append(all, own_report(0x02, 0x23, 47, 0x91));
  } else {
    append(all, own_report(0x31, 0x31, 77, 0x81));
    append(all, own_report(0x31, 0x32, 77, 0x91));
  }
  append(all, own_report(0x05, 0x33, 40, 0xB1));
  append(all, own_report(0x09, 0x24, 19, 0xB1));
  append(all, own_report(0x20, 0x26, 63, 0xB1));
  all.push_back(0xC0);
  return all;
}

void put_u16(Bytes& bytes, std::size_t at, int value) {
  bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
  bytes[at + 1] = static_cast<std::uint8_t>((value >> 8) & 0xFF);
}

// The last four bytes, low byte first.
void seal(Bytes& report, std::uint8_t seed) {
  const std::size_t summed = report.size() - 4;
  const std::uint32_t crc = pad_crc(seed, std::span(report).first(summed));
  for (std::size_t i = 0; i < 4; ++i) report[summed + i] = static_cast<std::uint8_t>(crc >> (8 * i));
}

// Gyroscopes and accelerometers with no bias, and ranges as an average pad has them.
Bytes calibration() {
  Bytes feature(41);
  feature[0] = 0x05;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put_u16(feature, 7 + 4 * axis, 8847);   // gyroscope, at its speed forward
    put_u16(feature, 9 + 4 * axis, -8847);  // and backward
    put_u16(feature, 23 + 4 * axis, 8192);  // accelerometer, at 1 g
    put_u16(feature, 25 + 4 * axis, -8192);
  }
  put_u16(feature, 19, 540);  // deg/s, what those speeds were
  put_u16(feature, 21, 540);
  return feature;
}

Bytes address() {
  Bytes feature(20);
  feature[0] = 0x09;
  for (std::uint8_t i = 0; i < 6; ++i) feature[1U + i] = static_cast<std::uint8_t>(0x10 + i);
  return feature;
}

Bytes versions(std::uint16_t firmware) {
  Bytes feature(64);
  feature[0] = 0x20;
  put_u16(feature, 24, 0x0413);  // hardware
  put_u16(feature, 28, 0x0104);
  put_u16(feature, 44, firmware);
  return feature;
}

HidFacts pad_facts(DualSenseModel::Bus bus, std::uint16_t firmware) {
  std::vector<Bytes> features{calibration(), address(), versions(firmware)};
  if (bus == DualSenseModel::Bus::bluetooth)
    for (Bytes& feature : features) seal(feature, kFeatureSeed);
  return {.id = {0x054c, 0x0ce6},
          .maker = "Sony Interactive Entertainment",
          .name = "Wireless Controller",
          .descriptor = pad_descriptor(bus),
          .features = std::move(features)};
}

}  // namespace

std::uint32_t pad_crc(std::uint8_t seed, std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  const auto take = [&crc](std::uint8_t byte) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
  };
  take(seed);
  std::ranges::for_each(bytes, take);
  return crc ^ 0xFFFFFFFF;
}

DualSenseModel::DualSenseModel(Bus bus, std::uint16_t firmware)
    : HidModel(pad_facts(bus, firmware)), bus_(bus) {}

void DualSenseModel::tilt(const std::array<std::uint8_t, 4>& sticks) {
  const std::lock_guard lock(mutex_);
  sticks_ = sticks;
}

// Of both after the number, by Bluetooth after one byte more: sticks, triggers, counter, keys.
std::optional<Bytes> DualSenseModel::say() {
  const std::lock_guard lock(mutex_);
  const bool usb = bus_ == Bus::usb;
  Bytes report(usb ? 64 : 78);
  report[0] = usb ? 0x01 : 0x31;
  const std::size_t at = usb ? 1 : 2;
  std::ranges::copy(sticks_, report.begin() + static_cast<std::ptrdiff_t>(at));
  report[at + 6] = count_++;
  report[at + 7] = 8;                        // the cross is let go
  report[at + 32] = report[at + 36] = 0x80;  // nothing touches its pad
  report[at + 52] = 0x08;                    // its battery is nearly full
  if (!usb) seal(report, kInputSeed);
  return report;
}

}  // namespace fulcrum::test
