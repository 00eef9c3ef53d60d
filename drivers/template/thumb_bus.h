#pragma once
// A template, to be copied: the driver of a device that nobody has, with motors, by HID: three axes and a
// button in, three forces out. tests/drivers/thumb_test.cpp alone builds it. A real one says here whose
// manual its numbers are from, and what was assumed.

#include <memory>
#include <optional>

#include "drivers/force/force_bus.h"
#include "drivers/hid/hid_bytes.h"
#include "drivers/hid/hid_port.h"

namespace fulcrum::thumb {

inline constexpr hid::HidId kIds[] = {{0xFFFF, 0x0001}};
inline std::span<const hid::HidId> usb_ids() {
  return kIds;
}

// Bytes in: x, y, z (int16, 10 um), buttons (a bit each). None: it is no such report.
struct Says {
  Vec3 p_DH = Vec3::Zero();  // m
  std::uint32_t buttons = 0;
};
std::optional<Says> decode(hid::Bytes report);

// Bytes out, after the number of the report, which is 0: x, y, z (int16, mN). What is no number is nought.
std::array<std::uint8_t, 7> encode(const Vec3& force_D);

class ThumbBus final : public ForceBus {
public:
  ThumbBus(std::unique_ptr<hid::HidPort> port, const DeviceDesc&) : port_(std::move(port)) {}
  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override;

private:
  std::unique_ptr<hid::HidPort> port_;
};

}  // namespace fulcrum::thumb
