#pragma once
// A UsbPort by libusb. A transfer in is always submitted, so that the device's packets are taken as soon as
// it has them; what it does at once goes on while the caller waits in read() or control().

#include <libusb.h>

#include <array>

#include "drivers/usb/usb_port.h"

namespace fulcrum::usb {

class LibusbPort final : public UsbPort {
public:
  // The device's handle, with its interface claimed, and its context: both are the port's from here on.
  LibusbPort(libusb_context* context, libusb_device_handle* device, const UsbEndpoints& endpoints);
  ~LibusbPort() override;  // what is under way is cancelled
  LibusbPort(const LibusbPort&) = delete;
  LibusbPort& operator=(const LibusbPort&) = delete;

  bool control(std::uint8_t request, std::uint16_t value) override;
  bool write(std::span<const std::uint8_t> bytes) override;
  int read(std::span<std::uint8_t> packet, int wait_ms) override;

private:
  static constexpr std::size_t kMostWaiting = 64;  // packets
  struct Packet {
    std::array<std::uint8_t, kPacketBytes> bytes{};
    std::size_t length = 0;
  };
  static void on_in(libusb_transfer* transfer);
  static void on_out(libusb_transfer* transfer);
  void take(const libusb_transfer& transfer);
  void submit_in();
  void lose(bool unplugged);
  // Has libusb do what is due until something has come or the time is over.
  void pump(int wait_ms);

  libusb_context* const context_;
  libusb_device_handle* const device_;
  const UsbEndpoints endpoints_;
  libusb_transfer *in_, *out_;
  std::array<std::uint8_t, kPacketBytes> in_bytes_{}, out_bytes_{};
  std::array<Packet, kMostWaiting> packets_{};  // a ring
  std::size_t first_ = 0, waiting_ = 0;
  int arrived_ = 0;  // as libusb is told that its caller need not wait any longer
  bool in_live_ = false, out_live_ = false;
  bool ends_ = false;
  bool gone_ = false;       // nothing more is read; what lets motors rest may still be written
  bool unplugged_ = false;  // nor is anything written
};

}  // namespace fulcrum::usb
