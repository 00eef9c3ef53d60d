#pragma once
// A recorded handle motion as a device: the same samples for any scene. It feels nothing.

#include <vector>

#include "haptics/device/device.h"

namespace fulcrum {

class ReplayDevice final : public Device {
public:
  // samples: one a tick, at least one; after the last one the handle rests. desc: the device to stand in for.
  ReplayDevice(const DeviceDesc& desc, std::vector<DeviceSample> samples);

  bool finished() const { return at_ >= samples_.size(); }

  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand&) noexcept override {}
  void miss(int ticks) noexcept override { at_ += static_cast<std::size_t>(ticks); }

private:
  DeviceDesc desc_;
  std::vector<DeviceSample> samples_;
  std::size_t at_ = 0;
};

}  // namespace fulcrum
