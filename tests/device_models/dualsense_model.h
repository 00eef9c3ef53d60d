#pragma once
// A Sony DualSense. It streams its sticks and keys, by USB in report 1, by Bluetooth in report 0x31 with a
// checksum. What it says of itself satisfies Linux's own driver, which asks for calibration, address and
// firmware.

#include <array>

#include "tests/device_models/hid_model.h"

namespace fulcrum::test {

// CRC-32 as zlib has it, of the seed and then the bytes: written apart from the drivers', which it judges.
std::uint32_t pad_crc(std::uint8_t seed, std::span<const std::uint8_t> bytes);

class DualSenseModel final : public HidModel {
public:
  enum class Bus { usb, bluetooth };
  // firmware: from 0x0215 on it is asked for rumble in another way.
  DualSenseModel(Bus bus, std::uint16_t firmware);

  // Left x, y, right x, y: 0 left or up, 128 let go.
  void tilt(const std::array<std::uint8_t, 4>& sticks);

  std::optional<Bytes> say() override;

private:
  const Bus bus_;
  std::array<std::uint8_t, 4> sticks_{128, 128, 128, 128};
  std::uint8_t count_ = 0;
};

}  // namespace fulcrum::test
