#include "drivers/usb/libusb_port.h"

#include <algorithm>
#include <chrono>

namespace fulcrum::usb {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLastWait_ms = 5;  // for what was sent before, where nothing is read any more
constexpr unsigned kControlLimit_ms = 200, kOutLimit_ms = 100;
constexpr std::int64_t kPumpStep_us = 2000;
constexpr int kMostPumps = 1000;  // at the end, for what was cancelled
constexpr int kLastPumps = 25;    // for what was sent last: it lets motors rest
constexpr std::uint8_t kVendorOut =
    LIBUSB_ENDPOINT_OUT | static_cast<std::uint8_t>(LIBUSB_REQUEST_TYPE_VENDOR) | LIBUSB_RECIPIENT_DEVICE;

}  // namespace

LibusbPort::LibusbPort(libusb_context* context, libusb_device_handle* device, const UsbEndpoints& endpoints)
    : context_(context),
      device_(device),
      endpoints_(endpoints),
      in_(libusb_alloc_transfer(0)),
      out_(libusb_alloc_transfer(0)) {
  gone_ = in_ == nullptr || out_ == nullptr;
  submit_in();
}

// libusb must have let go of both transfers before their memory goes. A kernel that does not give one back
// costs that memory, not the end of the program.
LibusbPort::~LibusbPort() {
  ends_ = true;
  for (int count = 0; out_live_ && !unplugged_ && count < kLastPumps; ++count) {
    timeval step{0, kPumpStep_us};
    libusb_handle_events_timeout_completed(context_, &step, nullptr);
  }
  if (in_live_) libusb_cancel_transfer(in_);
  if (out_live_) libusb_cancel_transfer(out_);
  for (int count = 0; (in_live_ || out_live_) && count < kMostPumps; ++count) {
    timeval step{0, kPumpStep_us};
    libusb_handle_events_timeout_completed(context_, &step, nullptr);
  }
  if (!in_live_) libusb_free_transfer(in_);
  if (!out_live_) libusb_free_transfer(out_);
  libusb_release_interface(device_, endpoints_.interface);
  libusb_close(device_);
  libusb_exit(context_);
}

bool LibusbPort::control(std::uint8_t request, std::uint16_t value) {
  return !gone_ &&
         libusb_control_transfer(device_, kVendorOut, request, value, 0, nullptr, 0, kControlLimit_ms) == 0;
}

bool LibusbPort::write(std::span<const std::uint8_t> bytes) {
  if (out_live_) pump(gone_ ? kLastWait_ms : 0);
  if (unplugged_ || out_live_ || bytes.size() > out_bytes_.size()) return false;
  std::ranges::copy(bytes, out_bytes_.begin());
  libusb_fill_bulk_transfer(out_, device_, endpoints_.out, out_bytes_.data(), static_cast<int>(bytes.size()),
                            &LibusbPort::on_out, this, kOutLimit_ms);
  const int error = libusb_submit_transfer(out_);
  out_live_ = error == 0;
  if (!out_live_) lose(error == LIBUSB_ERROR_NO_DEVICE);
  return out_live_;
}

int LibusbPort::read(std::span<std::uint8_t> packet, int wait_ms) {
  if (waiting_ == 0 && !gone_) pump(wait_ms);
  if (waiting_ == 0) return gone_ ? -1 : 0;
  const Packet& oldest = packets_[first_];
  const std::size_t length = std::min(oldest.length, packet.size());
  std::copy_n(oldest.bytes.begin(), length, packet.begin());
  first_ = (first_ + 1) % kMostWaiting;
  --waiting_;
  return static_cast<int>(length);
}

void LibusbPort::submit_in() {
  if (gone_) return;
  libusb_fill_bulk_transfer(in_, device_, endpoints_.in, in_bytes_.data(), static_cast<int>(in_bytes_.size()),
                            &LibusbPort::on_in, this, 0);
  const int error = libusb_submit_transfer(in_);
  in_live_ = error == 0;
  if (!in_live_) lose(error == LIBUSB_ERROR_NO_DEVICE);
}

void LibusbPort::lose(bool unplugged) {
  gone_ = true;
  unplugged_ = unplugged_ || unplugged;
  arrived_ = 1;
}

void LibusbPort::take(const libusb_transfer& transfer) {
  if (transfer.actual_length <= 0) return;
  if (waiting_ == kMostWaiting) {  // the oldest goes
    first_ = (first_ + 1) % kMostWaiting;
    --waiting_;
  }
  Packet& newest = packets_[(first_ + waiting_++) % kMostWaiting];
  newest.length = static_cast<std::size_t>(transfer.actual_length);
  std::copy_n(in_bytes_.begin(), newest.length, newest.bytes.begin());
  arrived_ = 1;
}

void LibusbPort::on_in(libusb_transfer* transfer) {
  LibusbPort& self = *static_cast<LibusbPort*>(transfer->user_data);
  self.in_live_ = false;
  if (self.ends_) return;
  if (transfer->status != LIBUSB_TRANSFER_COMPLETED)
    return self.lose(transfer->status == LIBUSB_TRANSFER_NO_DEVICE);
  self.take(*transfer);
  self.submit_in();
}

// What cannot be told to rest is as good as gone.
void LibusbPort::on_out(libusb_transfer* transfer) {
  LibusbPort& self = *static_cast<LibusbPort*>(transfer->user_data);
  self.out_live_ = false;
  if (transfer->status == LIBUSB_TRANSFER_COMPLETED && transfer->actual_length == transfer->length) {
    if (self.gone_) self.arrived_ = 1;  // the next one may go
    return;
  }
  self.lose(transfer->status == LIBUSB_TRANSFER_NO_DEVICE);
}

void LibusbPort::pump(int wait_ms) {
  const auto due = Clock::now() + std::chrono::milliseconds(wait_ms);
  arrived_ = 0;
  while (arrived_ == 0 && !unplugged_) {
    const std::int64_t left_us =
        std::chrono::duration_cast<std::chrono::microseconds>(due - Clock::now()).count();
    timeval step{0, std::clamp<std::int64_t>(left_us, 0, kPumpStep_us)};
    const int error = libusb_handle_events_timeout_completed(context_, &step, &arrived_);
    if (error != 0 && error != LIBUSB_ERROR_INTERRUPTED) gone_ = true;
    if (left_us <= 0) return;
  }
}

}  // namespace fulcrum::usb
