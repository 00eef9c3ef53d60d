#include "drivers/mouse/mouse_device.h"

namespace fulcrum {
namespace {

// Less delay than is seen (45 ms between picture and force).
constexpr double kLag = 15e-3;  // s

}  // namespace

DeviceDesc MouseDevice::mouse_desc() {
  DeviceDesc desc;
  desc.name = "mouse";
  desc.kinematics = Kinematics::none;
  desc.renders_force = false;
  desc.max_force = 0;
  return desc;
}

MouseDevice::MouseDevice(const DeviceDesc& desc, const Pose& X_DH, double tick_s)
    : desc_(desc), follower_(X_DH, kLag, tick_s) {
  aim(X_DH);
}

void MouseDevice::aim(const Pose& X_DH) noexcept {
  aim_.draft() = X_DH;
  aim_.publish();
}

DeviceSample MouseDevice::read() noexcept {
  DeviceSample sample;
  sample.X_DH = follower_.follow(aim_.newest());
  return sample;
}

}  // namespace fulcrum
