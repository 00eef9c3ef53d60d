#include "tests/device_models/usb_hid.h"

#include <string_view>

namespace fulcrum::test {
namespace {

constexpr std::uint8_t kEndpointIn = 1, kEndpointOut = 2;
// Requests of an interface, and of its HID (HID 1.11, 7.2), as those of every device.
constexpr int kGetOfInterface = 0x8106, kGetReport = 0xA101, kSetReport = 0x2109, kSetIdle = 0x210A;
constexpr int kOutput = 2, kFeature = 3;  // kinds of reports

std::uint8_t low(std::size_t value) {
  return static_cast<std::uint8_t>(value & 0xFF);
}
std::uint8_t high(std::size_t value) {
  return static_cast<std::uint8_t>((value >> 8) & 0xFF);
}

}  // namespace

std::optional<Bytes> UsbHid::control(const UsbSetup& setup, std::span<const std::uint8_t> data) {
  switch (setup.type << 8 | setup.request) {
    case kGetStatus:
      return Bytes{0, 0};
    case kGetDescriptor:
    case kGetOfInterface:
      return descriptor(setup.value);
    case kSetConfiguration:
      hid_.begin();
      return Bytes{};
    case kSetInterface:
    case kClearStall:
    case kSetIdle:
      return Bytes{};
    case kGetReport:
      if (setup.value >> 8 != kFeature) return std::nullopt;
      return hid_.feature(low(setup.value));
    case kSetReport:
      if (setup.value >> 8 != kOutput) return std::nullopt;
      hid_.hear(data);
      return Bytes{};
    default:
      return std::nullopt;
  }
}

bool UsbHid::out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) {
  if (!facts_.hears_by_interrupt || endpoint != kEndpointOut) return false;
  hid_.hear(bytes);
  return true;
}

std::optional<Bytes> UsbHid::in(std::uint8_t endpoint) {
  return endpoint == kEndpointIn ? hid_.say() : std::nullopt;
}

std::optional<Bytes> UsbHid::descriptor(std::uint16_t value) const {
  switch (value >> 8) {
    case 0x01:
      return device();
    case 0x02:
      return configuration();
    case 0x03:
      return string(low(value));
    case 0x21:
      return hid_descriptor();
    case 0x22:
      return hid_.facts().descriptor;
    default:
      return std::nullopt;
  }
}

Bytes UsbHid::device() const {
  const hid::HidId id = hid_.facts().id;
  return {
      18,   1,    0x00, 0x02, 0, 0, 0, 64, low(id.vendor), high(id.vendor), low(id.product), high(id.product),
      0x00, 0x01, 1,    2,    0, 1};
}

Bytes UsbHid::hid_descriptor() const {
  const std::size_t length = hid_.facts().descriptor.size();
  return {9, 0x21, 0x11, 0x01, 0, 1, 0x22, low(length), high(length)};
}

Bytes UsbHid::configuration() const {
  const std::uint8_t endpoints = facts_.hears_by_interrupt ? 2 : 1;
  Bytes all{9, 2, 0, 0, 1, 1, 0, 0x80, 50, 9, 4, 0, 0, endpoints, 3, 0, 0, 0};
  const auto append = [&all](const Bytes& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(hid_descriptor());
  append({7, 5, 0x80 | kEndpointIn, 3, 64, 0, facts_.interval});
  if (facts_.hears_by_interrupt) append({7, 5, kEndpointOut, 3, 64, 0, facts_.interval});
  all[2] = low(all.size());
  return all;
}

std::optional<Bytes> UsbHid::string(std::uint8_t number) const {
  if (number == 0) return Bytes{4, 3, 0x09, 0x04};  // English
  if (number > 2) return std::nullopt;
  const std::string_view text = number == 1 ? hid_.facts().maker : hid_.facts().name;
  Bytes all{low(2 + 2 * text.size()), 3};
  for (const char letter : text) {
    all.push_back(static_cast<std::uint8_t>(letter));
    all.push_back(0);
  }
  return all;
}

}  // namespace fulcrum::test
