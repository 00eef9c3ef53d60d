#pragma once
// A hand in a headset as a device, with a controller or without: six axes, as it holds the handle. It pushes
// nothing back.

#include <memory>

#include "drivers/controller/controllers.h"
#include "drivers/follow/pose_follower.h"
#include "haptics/device/device.h"

namespace fulcrum {

class ControllerDevice final : public Device {
public:
  // X_DH: where the handle is until a hand takes it. lag: s, of each of the two with which it follows.
  ControllerDevice(const DeviceDesc& desc, std::shared_ptr<Controllers> controllers, const Pose& X_DH,
                   double lag, double tick_s);

  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand&) noexcept override {}  // there is nothing to push
  void miss(int ticks) noexcept override;

private:
  DeviceDesc desc_;
  std::shared_ptr<Controllers> controllers_;
  PoseFollower follower_;
  double tick_s_;
  int unseen_ = 0;  // ticks, since the hand that holds it was seen
};

}  // namespace fulcrum
