#pragma once
// A Falcon's chip on a USB cable: its packets by bulk transfers, its settings by requests on endpoint 0.

#include <chrono>

#include "tests/device_models/falcon_model.h"
#include "tests/device_models/usb_model.h"

namespace fulcrum::test {

class FalconUsb final : public UsbModel {
public:
  explicit FalconUsb(FalconModel& falcon) : falcon_(falcon) {}

  UsbSpeed speed() const override { return UsbSpeed::full; }
  std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  bool out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) override;
  std::optional<Bytes> in(std::uint8_t endpoint) override;

private:
  using Clock = std::chrono::steady_clock;

  FalconModel& falcon_;
  Clock::time_point said_{};
};

}  // namespace fulcrum::test
