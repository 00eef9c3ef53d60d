#include "tests/drivers_kernel/uhid_device.h"

#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace fulcrum::test {
namespace {

constexpr int kEvery_ms = 4;  // a report

void tell_uhid(int file, const uhid_event& event) {
  if (write(file, &event, sizeof event) == static_cast<ssize_t>(sizeof event)) return;
  std::fprintf(stderr, "uhid refused event %u: %s\n", event.type, std::strerror(errno));
  std::abort();
}

uhid_event creation(const HidFacts& facts) {
  uhid_event event{};
  event.type = UHID_CREATE2;
  uhid_create2_req& wanted = event.u.create2;
  std::snprintf(reinterpret_cast<char*>(wanted.name), sizeof wanted.name, "%s", facts.name.c_str());
  std::ranges::copy(facts.descriptor, wanted.rd_data);
  wanted.rd_size = static_cast<__u16>(facts.descriptor.size());
  wanted.bus = BUS_BLUETOOTH;
  wanted.vendor = facts.id.vendor;
  wanted.product = facts.id.product;
  return event;
}

}  // namespace

UhidDevice::UhidDevice(HidModel& model) : model_(model), file_(open("/dev/uhid", O_RDWR | O_CLOEXEC)) {
  tell_uhid(file_, creation(model.facts()));
  thread_ = std::thread([this] { serve(); });
}

UhidDevice::~UhidDevice() {
  on_ = false;
  thread_.join();
  close(file_);  // which unplugs it
}

void UhidDevice::serve() {
  while (on_) {
    pollfd at{.fd = file_, .events = POLLIN, .revents = 0};
    if (poll(&at, 1, kEvery_ms) > 0) {
      take_event();
    } else if (started_) {
      const std::optional<Bytes> said = model_.say();
      if (!said) continue;
      uhid_event event{};
      event.type = UHID_INPUT2;
      event.u.input2.size = static_cast<__u16>(said->size());
      std::ranges::copy(*said, event.u.input2.data);
      tell_uhid(file_, event);
    }
  }
}

void UhidDevice::take_event() {
  uhid_event event{};
  if (read(file_, &event, sizeof event) <= 0) return;
  if (event.type == UHID_START) started_ = true;
  if (event.type == UHID_STOP) started_ = false;
  if (event.type == UHID_OUTPUT)
    model_.hear(std::span<const std::uint8_t>(&event.u.output.data[0], event.u.output.size));
  if (event.type != UHID_GET_REPORT) return;
  const std::optional<Bytes> feature = model_.feature(event.u.get_report.rnum);
  uhid_event reply{};
  reply.type = UHID_GET_REPORT_REPLY;
  reply.u.get_report_reply.id = event.u.get_report.id;
  reply.u.get_report_reply.err = feature ? 0 : EIO;
  if (feature) {
    reply.u.get_report_reply.size = static_cast<__u16>(feature->size());
    std::ranges::copy(*feature, reply.u.get_report_reply.data);
  }
  tell_uhid(file_, reply);
}

}  // namespace fulcrum::test
