#pragma once
// A cap, a pad or keys as a device: six axes in, nothing out.

#include <memory>

#include "drivers/rate/axes_source.h"
#include "drivers/rate/rate_control.h"
#include "haptics/device/device.h"
#include "haptics/loop/snapshot.h"

namespace fulcrum {

class RateDevice final : public Device {
public:
  // X_DH: where the handle begins.
  RateDevice(const DeviceDesc& desc, std::shared_ptr<AxesSource> pushed, const Pose& X_DH, double tick_s);

  // Main thread: what the trainee sees now.
  void look(const SeenFrame& seen) noexcept;

  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand&) noexcept override {}  // there is nothing to push
  void miss(int) noexcept override {}

private:
  DeviceDesc desc_;
  std::shared_ptr<AxesSource> pushed_;
  RateControl rate_;
  Snapshot<SeenFrame> seen_;
};

}  // namespace fulcrum
