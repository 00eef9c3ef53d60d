#include "drivers/strip/strip_device.h"

#include <utility>

namespace fulcrum::strip {

StripDevice::StripDevice(std::unique_ptr<Device> moves, std::unique_ptr<Device> senses)
    : moves_(std::move(moves)), senses_(std::move(senses)) {}

DeviceSample StripDevice::read() noexcept {
  DeviceSample sample = moves_->read();
  const DeviceSample felt = senses_->read();
  sample.strip_ohm = felt.connected && felt.age <= kOldest ? felt.strip_ohm : kNoStrip;
  return sample;
}

}  // namespace fulcrum::strip
