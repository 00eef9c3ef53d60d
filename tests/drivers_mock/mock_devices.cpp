#include "tests/drivers_mock/mock_devices.h"

#include <utility>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/spacemouse/spacemouse_protocol.h"

namespace fulcrum::test {

Bytes descriptor(std::uint8_t usage) {
  return {0x05, 0x01, 0x09, usage, 0xA1, 0x01,                          // generic desktop, usage, application
          0x85, 0x01, 0x09, 0x30,  0x75, 0x08, 0x95, 0x06, 0x81, 0x02,  // report 1: six bytes in
          0x85, 0x02, 0x09, 0x33,  0x75, 0x08, 0x95, 0x06, 0x81, 0x02, 0xC0};
}

MockHidFacts spacemouse() {
  return {.id = kSpaceMouse, .name = "SpaceMouse Compact", .descriptor = descriptor(kMultiAxisUsage)};
}

MockHidFacts dualsense(bool bluetooth, std::uint16_t firmware) {
  Bytes version(64), calibration(41);
  version[0] = 0x20;
  version[44] = static_cast<std::uint8_t>(firmware & 0xFF);
  version[45] = static_cast<std::uint8_t>(firmware >> 8);
  calibration[0] = 0x05;
  return {.id = kDualSense,
          .bluetooth = bluetooth,
          .name = "Wireless Controller",
          .descriptor = descriptor(kGamepadUsage),
          .features = {version, calibration}};
}

namespace {

hid::HidOpened opened(std::span<const hid::HidId> ids) {
  const std::vector<hid::HidPlace> places = hid::find_hid(ids);
  if (places.empty()) return {};
  auto port = hid::open_hid(places.front());
  if (!port) return {};
  const sony::Link link = places.front().bluetooth ? sony::Link::bluetooth : sony::Link::usb;
  if (places.front().id == kDualSense)
    return {std::move(*port), std::make_unique<dualsense::DualSenseProtocol>(link)};
  return {std::move(*port), std::make_unique<SpaceMouseProtocol>()};
}

}  // namespace

std::unique_ptr<hid::HidLink> linked(std::span<const hid::HidId> ids) {
  hid::HidOpened now = opened(ids);
  if (!now.port) return nullptr;
  return std::make_unique<hid::HidLink>(std::move(now), [ids] { return opened(ids); });
}

}  // namespace fulcrum::test
