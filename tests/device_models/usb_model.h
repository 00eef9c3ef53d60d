#pragma once
// A device at the far end of a USB cable, whatever stands in for the cable: requests on endpoint 0, bytes
// out, bytes in. Whoever carries the bus calls it from one thread.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum::test {

using Bytes = std::vector<std::uint8_t>;

// The eight bytes that begin a request on endpoint 0.
struct UsbSetup {
  std::uint8_t type = 0, request = 0;
  std::uint16_t value = 0, index = 0, length = 0;
};

// Requests that every device answers, by type and number: USB 2.0, table 9-4.
inline constexpr int kGetStatus = 0x8000, kClearStall = 0x0201, kGetDescriptor = 0x8006,
                     kSetConfiguration = 0x0009, kSetInterface = 0x010B;

enum class UsbSpeed { full, high };

class UsbModel {
public:
  virtual ~UsbModel() = default;
  virtual UsbSpeed speed() const = 0;
  // data: what the host sends with it. The answer, empty where nothing is asked for; none: it stalls.
  virtual std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t> data) = 0;
  // endpoint: without the bit of its direction, 1 to 15. False: it stalls.
  virtual bool out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) = 0;
  // Asked once in the endpoint's interval. None: it has nothing to say yet.
  virtual std::optional<Bytes> in(std::uint8_t endpoint) = 0;
};

}  // namespace fulcrum::test
