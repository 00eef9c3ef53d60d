#pragma once
// A model of a device, plugged into this machine's own kernel: its virtual host controller (vhci-hcd) takes
// one end of a socket, and the device's end of USB/IP is spoken on the other (Linux,
// Documentation/usb/usbip_protocol.rst). Needs root.

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/device_models/usb_model.h"

namespace fulcrum::test {

class UsbipDevice {
public:
  // Plugged in. model: outlives it.
  explicit UsbipDevice(UsbModel& model);
  ~UsbipDevice();
  UsbipDevice(const UsbipDevice&) = delete;
  UsbipDevice& operator=(const UsbipDevice&) = delete;

  void plug();
  void unplug();

private:
  using Clock = std::chrono::steady_clock;
  // The host waits for what an endpoint says.
  struct Waiting {
    std::uint32_t number = 0;  // of the request
    std::uint8_t endpoint = 0;
    std::uint32_t room = 0;
    Clock::duration interval{};
    Clock::time_point due{};
  };

  void serve();
  bool take_request();
  bool submit(const std::vector<std::uint32_t>& head, const UsbSetup& setup);
  bool unlink(std::uint32_t number, std::uint32_t unlinked);
  // When the next of those that wait is due.
  Clock::time_point ask_due();
  bool answer(std::uint32_t number, int status, std::uint32_t length, std::span<const std::uint8_t> data);

  UsbModel& model_;
  int port_ = -1, socket_ = -1;
  std::vector<Waiting> waiting_;
  std::map<std::uint8_t, Clock::time_point> said_;  // when an endpoint was asked last
  std::thread thread_;
};

}  // namespace fulcrum::test
