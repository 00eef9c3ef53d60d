#include "drivers/rate/rate_device.h"

#include <utility>

namespace fulcrum {

RateDevice::RateDevice(const DeviceDesc& desc, std::shared_ptr<AxesSource> pushed, const Pose& X_DH,
                       double tick_s)
    : desc_(desc), pushed_(std::move(pushed)), rate_(RateControlDesc(), X_DH, tick_s) {}

void RateDevice::look(const SeenFrame& seen) noexcept {
  seen_.draft() = seen;
  seen_.publish();
}

DeviceSample RateDevice::read() noexcept {
  const AxesReading reading = pushed_->read();
  const SeenFrame& seen = seen_.newest();
  // What is not there pushes nothing: the last thing that it said would go on for ever.
  const PushedAxes& axes = reading.connected ? reading.axes : PushedAxes{};
  DeviceSample sample;
  sample.X_DH = rate_.advance(axes, seen);
  sample.age = reading.age;
  sample.buttons = axes.buttons;
  sample.connected = reading.connected;
  return sample;
}

}  // namespace fulcrum
