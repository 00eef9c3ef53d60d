#include "drivers/vibrating/vibrating_device.h"

#include <utility>

namespace fulcrum {

VibratingDevice::VibratingDevice(std::unique_ptr<Device> moves, std::unique_ptr<Vibrator> vibrates)
    : moves_(std::move(moves)), vibrates_(std::move(vibrates)) {}

DeviceSample VibratingDevice::read() noexcept {
  DeviceSample sample = moves_->read();
  sample.connected = sample.connected && vibrates_->connected();
  return sample;
}

void VibratingDevice::write(const DeviceCommand& command) noexcept {
  moves_->write(command);
  vibrates_->drive(command.vibrotactile);
}

}  // namespace fulcrum
