#pragma once
// A device that something vibrates beside: where the hand is comes from the one, what the skin is told goes
// to the other. Both may be one pad.

#include <memory>
#include <vector>

#include "drivers/rate/axes_source.h"
#include "haptics/actuation/vibrotactile_output.h"
#include "haptics/device/device.h"

namespace fulcrum {

class VibratingDevice final : public Device {
public:
  // moves: its desc() has the channels of `vibrates`, all of rumble. signal: what they are to render.
  VibratingDevice(std::unique_ptr<Device> moves, std::shared_ptr<AxesSource> vibrates,
                  const VibrotactileSignal& signal, double tick_s);

  const DeviceDesc& desc() const override { return moves_->desc(); }
  // The run needs both: it stops where one of them is lost.
  DeviceSample read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void miss(int ticks) noexcept override { moves_->miss(ticks); }

private:
  std::unique_ptr<Device> moves_;
  std::shared_ptr<AxesSource> vibrates_;
  std::vector<ChannelOutput> outputs_;
};

}  // namespace fulcrum
