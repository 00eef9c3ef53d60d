#pragma once
// A device that something vibrates beside: where the hand is comes from the one, what the skin is told goes
// to the other. Both may be one pad.

#include <memory>

#include "drivers/vibrating/vibrator.h"
#include "haptics/device/device.h"

namespace fulcrum {

class VibratingDevice final : public Device {
public:
  // moves: its desc() has the channels of `vibrates`.
  VibratingDevice(std::unique_ptr<Device> moves, std::unique_ptr<Vibrator> vibrates);

  const DeviceDesc& desc() const override { return moves_->desc(); }
  // The run needs both: it stops where one of them is lost.
  DeviceSample read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void miss(int ticks) noexcept override { moves_->miss(ticks); }

private:
  std::unique_ptr<Device> moves_;
  std::unique_ptr<Vibrator> vibrates_;
};

}  // namespace fulcrum
