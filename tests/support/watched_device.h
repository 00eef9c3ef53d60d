#pragma once
// Any device, on a haptic thread whose system calls are watched from its first tick on.

#include <atomic>
#include <memory>
#include <utility>

#include "haptics/device/device.h"
#include "tests/support/system_calls.h"

namespace fulcrum::test {

class WatchedDevice final : public Device {
public:
  WatchedDevice(std::unique_ptr<Device> device, SystemCalls& calls)
      : device_(std::move(device)), calls_(calls) {}

  const DeviceDesc& desc() const override { return device_->desc(); }
  DeviceSample read() noexcept override {
    if (state_ == State::begins) state_ = calls_.watch() ? State::watched : State::refused;
    return device_->read();
  }
  void write(const DeviceCommand& command) noexcept override { device_->write(command); }
  void miss(int ticks) noexcept override { device_->miss(ticks); }

  // This system does not let a thread be watched.
  bool refused() const { return state_ == State::refused; }

private:
  enum class State { begins, watched, refused };
  std::unique_ptr<Device> device_;
  SystemCalls& calls_;
  std::atomic<State> state_{State::begins};
};

}  // namespace fulcrum::test
