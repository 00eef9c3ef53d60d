#pragma once
// USB vendor and product of a device.

#include <cstdint>

namespace fulcrum::hid {

struct HidId {
  std::uint16_t vendor = 0, product = 0;
  bool operator==(const HidId&) const = default;
};

}  // namespace fulcrum::hid
