#include "tests/drivers_kernel/usbip_device.h"

#include <endian.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fulcrum::test {
namespace {

const std::string kController = "/sys/devices/platform/vhci_hcd.0/";
// A message begins with 12 words, high byte first, and the 8 bytes of a setup.
constexpr std::size_t kWords = 12, kHead = 48;
constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinked = 4, kIn = 1;
enum Word { command, number, device, direction, endpoint, flags, length, start, packets, interval };
constexpr int kFree = 4;                                  // a port's state
constexpr auto kAskAgain = std::chrono::milliseconds(1);  // where an endpoint has no interval

// Nothing can be tested where the kernel refuses, and a destructor throws nothing.
void expect_done(bool done, const char* what) {
  if (done) return;
  std::fprintf(stderr, "vhci-hcd: %s: %s\n", what, std::strerror(errno));
  std::abort();
}

void tell_controller(const char* file, const std::string& text) {
  std::ofstream to(kController + file);
  to << text << std::flush;
  expect_done(static_cast<bool>(to), file);
}

int state_of(int port) {
  std::ifstream status(kController + "status");
  std::string line;
  std::getline(status, line);
  while (std::getline(status, line)) {
    std::istringstream words(line);
    std::string hub;
    int number = -1, state = -1;
    words >> hub >> number >> state;
    if (number == port) return state;
  }
  return -1;
}

// Those of full and high speed come first.
int free_port() {
  int port = 0;
  while (state_of(port) != kFree) {
    expect_done(state_of(port) >= 0, "no free port");
    ++port;
  }
  return port;
}

// Its drivers have let go of it only when this is gone. The first ports are those of the hub that has the
// lowest number.
bool shown(int port) {
  std::error_code none;
  for (const auto& hub : std::filesystem::directory_iterator(kController, none)) {
    if (!hub.path().filename().string().starts_with("usb")) continue;
    const std::string bus = hub.path().filename().string().substr(3);
    if (std::filesystem::exists(hub.path() / (bus + "-" + std::to_string(port + 1)), none)) return true;
  }
  return false;
}

bool receive(int socket, std::span<std::uint8_t> bytes) {
  return bytes.empty() ||
         recv(socket, bytes.data(), bytes.size(), MSG_WAITALL) == static_cast<ssize_t>(bytes.size());
}

bool send_all(int socket, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

std::uint16_t low_first(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}

Bytes head_of(const std::array<std::uint32_t, kWords>& words) {
  Bytes head(kHead);
  for (std::size_t i = 0; i < kWords; ++i) {
    const std::uint32_t word = htobe32(words[i]);
    std::memcpy(head.data() + 4 * i, &word, sizeof word);
  }
  return head;
}

}  // namespace

UsbipDevice::UsbipDevice(UsbModel& model) : model_(model) {
  plug();
}

UsbipDevice::~UsbipDevice() {
  unplug();
}

void UsbipDevice::plug() {
  int ends[2];
  expect_done(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0, "a pair of sockets");
  socket_ = ends[0];
  port_ = free_port();
  const int speed = model_.speed() == UsbSpeed::high ? 3 : 2;  // enum usb_device_speed
  // Its number there is nobody's but this end's.
  tell_controller("attach",
                  std::to_string(port_) + " " + std::to_string(ends[1]) + " 65538 " + std::to_string(speed));
  close(ends[1]);  // the kernel has it
  thread_ = std::thread([this] { serve(); });
}

// The kernel closes its end, by which the thread sees that it is over.
void UsbipDevice::unplug() {
  if (!thread_.joinable()) return;
  tell_controller("detach", std::to_string(port_));
  thread_.join();
  close(socket_);
  waiting_.clear();
  said_.clear();
  while (state_of(port_) != kFree || shown(port_)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void UsbipDevice::serve() {
  bool goes_on = true;
  while (goes_on) {
    const Clock::time_point due = ask_due();
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(due - Clock::now()).count();
    const timespec wait{left / 1'000'000'000, left % 1'000'000'000};
    pollfd at{.fd = socket_, .events = POLLIN, .revents = 0};
    const int ready = left < 0 ? 0 : ppoll(&at, 1, waiting_.empty() ? nullptr : &wait, nullptr);
    if (ready > 0) goes_on = take_request();
  }
}

bool UsbipDevice::take_request() {
  Bytes bytes(kHead);
  if (!receive(socket_, bytes)) return false;
  std::vector<std::uint32_t> head(kWords);
  for (std::size_t i = 0; i < kWords; ++i) {
    std::memcpy(&head[i], bytes.data() + 4 * i, 4);
    head[i] = be32toh(head[i]);
  }
  if (head[command] == kUnlink) return unlink(head[number], head[flags]);
  if (head[command] != kSubmit) return false;
  const std::span<const std::uint8_t> setup = std::span(bytes).subspan(40);
  return submit(head, {setup[0], setup[1], low_first(setup.subspan(2)), low_first(setup.subspan(4)),
                       low_first(setup.subspan(6))});
}

bool UsbipDevice::submit(const std::vector<std::uint32_t>& head, const UsbSetup& setup) {
  const auto at = static_cast<std::uint8_t>(head[endpoint]);
  Bytes data(head[direction] == kIn ? 0 : head[length]);
  if (!receive(socket_, data)) return false;
  if (at == 0) {
    std::optional<Bytes> said = model_.control(setup, data);
    if (!said) return answer(head[number], -EPIPE, 0, {});
    if (head[direction] != kIn) return answer(head[number], 0, head[length], {});
    said->resize(std::min<std::size_t>(said->size(), head[length]));
    return answer(head[number], 0, static_cast<std::uint32_t>(said->size()), *said);
  }
  if (head[direction] != kIn) {
    const bool taken = model_.out(at, data);
    return answer(head[number], taken ? 0 : -EPIPE, taken ? head[length] : 0, {});
  }
  // The host counts it in frames of a millisecond, at high speed in eighths of them.
  const Clock::duration every =
      head[interval] * std::chrono::microseconds(model_.speed() == UsbSpeed::high ? 125 : 1000);
  waiting_.push_back({head[number], at, head[length], every, said_[at] + every});
  return true;
}

// The host no longer waits for it; if it was answered already, that has crossed this.
bool UsbipDevice::unlink(std::uint32_t by, std::uint32_t unlinked) {
  const bool waited = std::erase_if(waiting_, [&](const Waiting& one) { return one.number == unlinked; }) > 0;
  std::array<std::uint32_t, kWords> head{kUnlinked, by};
  head[flags] = waited ? static_cast<std::uint32_t>(-ECONNRESET) : 0;
  return send_all(socket_, head_of(head));
}

UsbipDevice::Clock::time_point UsbipDevice::ask_due() {
  Clock::time_point next = Clock::now() + std::chrono::hours(1);
  for (std::size_t i = 0; i < waiting_.size();) {
    Waiting& one = waiting_[i];
    const Clock::time_point now = Clock::now();
    if (now >= one.due) {
      said_[one.endpoint] = now;
      if (std::optional<Bytes> said = model_.in(one.endpoint)) {
        said->resize(std::min<std::size_t>(said->size(), one.room));
        answer(one.number, 0, static_cast<std::uint32_t>(said->size()), *said);
        waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      one.due = now + std::max<Clock::duration>(one.interval, kAskAgain);
    }
    next = std::min(next, one.due);
    ++i;
  }
  return next;
}

bool UsbipDevice::answer(std::uint32_t to, int status, std::uint32_t count,
                         std::span<const std::uint8_t> data) {
  std::array<std::uint32_t, kWords> head{kSubmitted, to};
  head[flags] = static_cast<std::uint32_t>(status);  // where an answer has its status
  head[length] = count;
  Bytes message = head_of(head);
  message.insert(message.end(), data.begin(), data.end());
  return send_all(socket_, message);
}

}  // namespace fulcrum::test
