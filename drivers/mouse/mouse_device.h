#pragma once
// A mouse as a device: six axes in, none out. The main thread turns drags and wheel steps into a wanted
// handle pose; the haptic thread follows it smoothly, since a mouse moves in steps of a screen's refresh.

#include "drivers/follow/pose_follower.h"
#include "haptics/device/device.h"
#include "haptics/loop/snapshot.h"

namespace fulcrum {

class MouseDevice final : public Device {
public:
  // desc: mouse_desc(), where nothing vibrates beside it. X_DH: where the handle is until aim() says
  // otherwise.
  MouseDevice(const DeviceDesc& desc, const Pose& X_DH, double tick_s);

  static DeviceDesc mouse_desc();

  // Main thread: where the handle shall go.
  void aim(const Pose& X_DH) noexcept;

  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand&) noexcept override {}  // there is nothing to push
  void miss(int) noexcept override {}

private:
  DeviceDesc desc_;
  PoseFollower follower_;
  Snapshot<Pose> aim_;
};

}  // namespace fulcrum
