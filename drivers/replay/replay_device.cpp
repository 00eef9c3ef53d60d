#include "drivers/replay/replay_device.h"

#include <utility>

namespace fulcrum {

ReplayDevice::ReplayDevice(const DeviceDesc& desc, std::vector<DeviceSample> samples)
    : desc_(desc), samples_(std::move(samples)) {}

DeviceSample ReplayDevice::read() noexcept {
  const DeviceSample sample = finished() ? samples_.back() : samples_[at_];
  ++at_;
  return sample;
}

}  // namespace fulcrum
