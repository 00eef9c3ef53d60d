#pragma once
// A device with one fault that begins at a set time. It is the device's own samples and commands that the
// fault spoils: what follows from there is what runs without it.

#include <cstdint>
#include <memory>
#include <vector>

#include "drivers/fault/injected_fault.h"
#include "haptics/device/device.h"

namespace fulcrum {

class FaultyDevice final : public Device {
public:
  // fault: one of the device.
  FaultyDevice(std::unique_ptr<Device> device, const InjectedFault& fault, double tick_s);

  const DeviceDesc& desc() const override { return device_->desc(); }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void miss(int ticks) noexcept override;

private:
  std::int64_t ticks(double seconds) const;
  // Within `seconds` of the fault's beginning.
  bool lasts(double seconds) const { return since_ >= 0 && since_ < ticks(seconds); }
  DeviceSample spoilt(const DeviceSample& now) noexcept;
  DeviceSample held() const noexcept;  // the last sample before the fault, as old as it is by now
  DeviceSample nonsense(DeviceSample sample) noexcept;

  std::unique_ptr<Device> device_;
  Injection kind_;
  double tick_s_;
  std::int64_t since_;  // ticks since the fault began; before it below 0
  DeviceSample before_;
  DeviceCommand heard_;                // the last command before the fault
  std::vector<DeviceSample> earlier_;  // a ring, of what comes late
  bool begun_ = false;                 // a sample has come
  std::size_t at_ = 0;
  std::uint64_t noise_ = 1;
};

}  // namespace fulcrum
