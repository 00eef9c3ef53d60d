#pragma once
// A headset's controller as a device: six axes by the hand that holds it, as it is held. It pushes nothing
// back.

#include <memory>

#include "drivers/controller/controllers.h"
#include "drivers/follow/pose_follower.h"
#include "haptics/device/device.h"

namespace fulcrum {

class ControllerDevice final : public Device {
public:
  // X_DH: where the handle is until a hand takes it.
  ControllerDevice(const DeviceDesc& desc, std::shared_ptr<Controllers> controllers, const Pose& X_DH,
                   double tick_s);

  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand&) noexcept override {}  // there is nothing to push
  void miss(int) noexcept override {}

private:
  DeviceDesc desc_;
  std::shared_ptr<Controllers> controllers_;
  PoseFollower follower_;
};

}  // namespace fulcrum
