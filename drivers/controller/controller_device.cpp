#include "drivers/controller/controller_device.h"

#include <algorithm>
#include <utility>

namespace fulcrum {
namespace {

// Ticks: older than any sample that is used, and far from the largest int.
constexpr int kUnseenLong = 1'000'000;

}  // namespace

ControllerDevice::ControllerDevice(const DeviceDesc& desc, std::shared_ptr<Controllers> controllers,
                                   const Pose& X_DH, double lag, double tick_s)
    : desc_(desc), controllers_(std::move(controllers)), follower_(X_DH, lag, tick_s), tick_s_(tick_s) {
  controllers_->move({X_DH});
}

// By ticks: pictures come when the headset wants them, and a late one makes no hand unseen.
DeviceSample ControllerDevice::read() noexcept {
  const WantedHandle& wanted = controllers_->wanted();
  unseen_ = wanted.seen ? 0 : std::min(unseen_ + 1, kUnseenLong);
  DeviceSample sample;
  sample.X_DH = follower_.follow(wanted.X_DH);
  sample.age = unseen_ * tick_s_;
  return sample;
}

void ControllerDevice::miss(int ticks) noexcept {
  if (unseen_ > 0) unseen_ = std::min(unseen_ + ticks, kUnseenLong);
}

}  // namespace fulcrum
