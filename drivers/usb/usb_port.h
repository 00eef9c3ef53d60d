#pragma once
// An open USB device without a driver of the kernel's, as packets: one endpoint in, one out, and requests to
// the device. Used by one thread at a time.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drivers/hid/hid_id.h"
#include "haptics/math/result.h"

namespace fulcrum::usb {

inline constexpr std::size_t kPacketBytes = 64;  // the longest of a full-speed bulk endpoint

class UsbPort {
public:
  virtual ~UsbPort() = default;
  // A request of the vendor's to the device, without data. False: it was refused, or the device is gone.
  virtual bool control(std::uint8_t request, std::uint16_t value) = 0;
  // Begins to send, kPacketBytes at most. False: what was sent before is still on its way, or the device is
  // gone.
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
  // The oldest packet that waits. Bytes that were read; 0: none came in that time; below 0: the device is
  // gone. packet: of kPacketBytes. wait_ms: 0 does not wait.
  virtual int read(std::span<std::uint8_t> packet, int wait_ms) = 0;
};

// A device that is plugged in.
struct UsbPlace {
  int bus = 0, address = 0;
  std::string path{};     // of its node
  bool permitted = true;  // the node may be read and written
  std::string serial{};   // where it has one
  std::string port{};     // that it is plugged in at, as the kernel names it: 1-2.3
};
// Those of `ids` that are there now, in the order of their paths.
std::vector<UsbPlace> find_usb(std::span<const hid::HidId> ids);

// Where bytes go in and out.
struct UsbEndpoints {
  int interface = 0;
  std::uint8_t in = 0x81, out = 0x02;
};
// Errors: it cannot be opened, with what would cure it.
Result<std::unique_ptr<UsbPort>> open_usb(const UsbPlace& place, const UsbEndpoints& endpoints);

}  // namespace fulcrum::usb
