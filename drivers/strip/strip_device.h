#pragma once
// A device with a strip on its handle that has a board of its own: where the hand is comes from the one,
// where along the handle it holds from the other.

#include <memory>

#include "haptics/device/device.h"

namespace fulcrum::strip {

class StripDevice final : public Device {
public:
  static constexpr double kOldest = 0.02;  // s, of a reading that is shown

  // moves: its desc() has the figures of the strip. senses: its samples are readings alone.
  StripDevice(std::unique_ptr<Device> moves, std::unique_ptr<Device> senses);

  const DeviceDesc& desc() const override { return moves_->desc(); }
  // A strip that is lost or silent has no reading. The run does not need it as it needs the handle: whoever
  // asks where it is held keeps the last place, says so (kHoldingPointLost) and goes to the scene's own,
  // slowly.
  DeviceSample read() noexcept override;
  void write(const DeviceCommand& command) noexcept override { moves_->write(command); }
  void miss(int ticks) noexcept override { moves_->miss(ticks); }

private:
  std::unique_ptr<Device> moves_, senses_;
};

}  // namespace fulcrum::strip
