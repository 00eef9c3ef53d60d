#pragma once
// A Falcon on a cable on which no time passes: what the model does not say at once, it does not say. Who does
// not wait gets what has come before alone.

#include <algorithm>
#include <deque>
#include <utility>

#include "drivers/falcon/falcon_boot.h"
#include "drivers/usb/usb_port.h"
#include "haptics/math/split_mix.h"
#include "tests/device_models/falcon_model.h"

namespace fulcrum::test {

inline FalconModel::Bytes firmware_of(std::size_t length) {
  SplitMix random(length);
  FalconModel::Bytes bytes(length);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.uniform() * 256);
  return bytes;
}
inline falcon::FalconBoot::Firmware brings(const FalconModel::Bytes& firmware) {
  return [firmware] { return Result<std::vector<std::uint8_t>>(firmware); };
}
inline Result<std::vector<std::uint8_t>> brings_none() {
  return Error{"there is no firmware."};
}

class FalconCable final : public usb::UsbPort {
public:
  explicit FalconCable(FalconModel& model) : model_(model) {}
  bool control(std::uint8_t request, std::uint16_t value) override {
    return plugged && model_.control(0x40, request, value, 0);
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    if (!plugged || !takes || bytes.size() > usb::kPacketBytes) return false;
    model_.out(bytes);
    return true;
  }
  int read(std::span<std::uint8_t> packet, int wait_ms) override {
    if (!plugged) return -1;
    if (wait_ms > 0 && held_.size() <= late && model_.has_more()) held_.push_back(model_.in());
    if (held_.size() <= late) return 0;
    const FalconModel::Bytes next = std::move(held_.front());
    held_.pop_front();
    std::ranges::copy(next, packet.begin());
    return static_cast<int>(next.size());
  }

  bool plugged = true, takes = true;
  std::size_t late = 0;  // answers that are held back

private:
  FalconModel& model_;
  std::deque<FalconModel::Bytes> held_;
};

}  // namespace fulcrum::test
