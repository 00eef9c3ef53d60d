#include "drivers/vibrating/vibrating_device.h"

#include <utility>

namespace fulcrum {

VibratingDevice::VibratingDevice(std::unique_ptr<Device> moves, std::shared_ptr<AxesSource> vibrates,
                                 const VibrotactileSignal& signal, double tick_s)
    : moves_(std::move(moves)), vibrates_(std::move(vibrates)) {
  for (const ChannelDesc& channel : moves_->desc().vibrotactile->channels)
    outputs_.emplace_back(channel, signal, tick_s);
}

DeviceSample VibratingDevice::read() noexcept {
  DeviceSample sample = moves_->read();
  sample.connected = sample.connected && vibrates_->read().connected;
  return sample;
}

void VibratingDevice::write(const DeviceCommand& command) noexcept {
  moves_->write(command);
  ChannelDrives drives{};
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const auto rendered = outputs_[i].process(command.vibrotactile.level[i], command.vibrotactile);
    if (!rendered.empty()) drives[i] = rendered.back();
  }
  vibrates_->drive(drives);
}

}  // namespace fulcrum
