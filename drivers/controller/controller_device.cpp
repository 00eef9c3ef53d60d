#include "drivers/controller/controller_device.h"

#include <utility>

namespace fulcrum {
namespace {

// A headset's runtime tells where a hand will be when the picture is seen, 20 to 40 ms ahead: following takes
// a part of that, and none of it is felt.
constexpr double kLag = 8e-3;  // s

}  // namespace

ControllerDevice::ControllerDevice(const DeviceDesc& desc, std::shared_ptr<Controllers> controllers,
                                   const Pose& X_DH, double tick_s)
    : desc_(desc), controllers_(std::move(controllers)), follower_(X_DH, kLag, tick_s) {
  controllers_->move(X_DH);
}

DeviceSample ControllerDevice::read() noexcept {
  DeviceSample sample;
  sample.X_DH = follower_.follow(controllers_->wanted_X_DH());
  return sample;
}

}  // namespace fulcrum
