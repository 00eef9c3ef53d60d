#pragma once
// A HID model on a USB cable: one interface, its reports by interrupts, the rest by requests on endpoint 0.

#include "tests/device_models/hid_model.h"
#include "tests/device_models/usb_model.h"

namespace fulcrum::test {

struct UsbHidFacts {
  UsbSpeed speed = UsbSpeed::full;
  std::uint8_t interval = 8;  // as its descriptor has it: ms at full speed, 2^(interval - 1) / 8 ms at high
  bool hears_by_interrupt = false;  // false: what it is told comes by requests
};

class UsbHid final : public UsbModel {
public:
  UsbHid(HidModel& hid, const UsbHidFacts& facts) : hid_(hid), facts_(facts) {}

  UsbSpeed speed() const override { return facts_.speed; }
  std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  bool out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) override;
  std::optional<Bytes> in(std::uint8_t endpoint) override;

private:
  std::optional<Bytes> descriptor(std::uint16_t value) const;
  std::optional<Bytes> string(std::uint8_t number) const;
  Bytes device() const;
  Bytes configuration() const;
  Bytes hid_descriptor() const;

  HidModel& hid_;
  const UsbHidFacts facts_;
};

}  // namespace fulcrum::test
