#pragma once
// The serial line between a Falcon's USB chip, an FTDI, and its processor. The chip puts two bytes of the
// line's state before whatever it brings, and brings these alone where it has nothing else.

#include <cstdint>
#include <span>

#include "drivers/usb/usb_port.h"

namespace fulcrum::falcon {

class FalconLine {
public:
  static constexpr std::size_t kMostRead = usb::kPacketBytes - 2;

  explicit FalconLine(usb::UsbPort& port) : port_(port) {}

  // Settings. False: the chip refused them, or is gone.
  bool to_greet();     // the processor is reset, and its boot loader listens at 9600 baud
  bool to_load();      // it takes firmware, at 140,000 baud
  bool to_exchange();  // the firmware's packets

  bool write(std::span<const std::uint8_t> bytes) { return port_.write(bytes); }
  // As UsbPort::read(), of what is on the line. bytes: of kMostRead.
  int read(std::span<std::uint8_t> bytes, int wait_ms);

private:
  struct Setting {
    std::uint8_t request = 0;
    std::uint16_t value = 0;
  };
  bool set(std::span<const Setting> settings);

  usb::UsbPort& port_;
};

}  // namespace fulcrum::falcon
