#include "tests/drivers_mock/mock_hid.h"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <utility>

namespace fulcrum::test {
namespace {

// Here is no sound: ALSA would look for 32 cards, and umockdev has places for 50 nodes, of which those that
// could not be opened keep theirs.
// NOLINTNEXTLINE(concurrency-mt-unsafe): no thread runs yet.
[[maybe_unused]] const int kNoSound = setenv("ALSA_CONFIG_PATH", "/dev/null", 1);

std::string formatted(const char* format, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string hex(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += formatted("%02X", byte);
  return text;
}

// What the ioctl's argument points to becomes these bytes.
void fill(UMockdevIoctlClient* client, std::span<const std::uint8_t> bytes) {
  GError* error = nullptr;
  UMockdevIoctlData* const data =
      umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, bytes.size(), &error);
  if (data == nullptr) return;
  Bytes copy(bytes.begin(), bytes.end());
  umockdev_ioctl_data_update(data, 0, copy.data(), static_cast<gint>(copy.size()));
  umockdev_ioctl_data_unref(data);
}

template <class T>
std::span<const std::uint8_t> bytes_of(const T& value) {
  return {reinterpret_cast<const std::uint8_t*>(&value), sizeof value};
}

// Nothing can be tested where umockdev refuses, and a destructor throws nothing.
void succeeds(bool done, const GError* error) {
  if (done) return;
  std::fprintf(stderr, "umockdev refused: %s\n", error != nullptr ? error->message : "it does not say why");
  std::abort();
}

}  // namespace

MockMachine::MockMachine()
    : testbed_(umockdev_testbed_new()), stands_in_(umockdev_in_mock_environment() != FALSE) {}

MockMachine::~MockMachine() {
  g_object_unref(testbed_);
}

void MockMachine::add(const std::string& tree) {
  GError* error = nullptr;
  succeeds(umockdev_testbed_add_from_string(testbed_, tree.c_str(), &error) != FALSE, error);
}

MockHid::MockHid(MockMachine& machine, MockHidFacts facts)
    : machine_(machine), facts_(std::move(facts)), handler_(umockdev_ioctl_base_new()) {
  const auto connect = [this](const char* signal,
                              gboolean (*answers)(UMockdevIoctlBase*, UMockdevIoctlClient*, gpointer)) {
    g_signal_connect_data(handler_, signal, reinterpret_cast<GCallback>(answers), this, nullptr,
                          static_cast<GConnectFlags>(0));
  };
  connect("handle-ioctl", &MockHid::on_ioctl);
  connect("handle-read", &MockHid::on_read);
  connect("handle-write", &MockHid::on_write);
  plug();
}

MockHid::~MockHid() {
  unplug();
  for (const std::string& node : nodes_)
    umockdev_testbed_detach_ioctl(machine_.testbed_, node.c_str(), nullptr);
  g_signal_handlers_disconnect_matched(handler_, G_SIGNAL_MATCH_DATA, 0, 0, nullptr, nullptr, this);
  g_object_unref(handler_);
}

// The tree is what Linux shows of such a device. What answers for the node is there before the node is: who
// finds a node finds all of it.
void MockHid::plug() {
  const int number = machine_.next_number_++;
  const std::string node = formatted("hidraw%d", number);
  const unsigned bus = facts_.bluetooth ? 5 : 3;
  const unsigned vendor = facts_.id.vendor, product = facts_.id.product;
  node_ = "/dev/" + node;
  paths_.clear();
  std::string tree;
  std::string path = facts_.bluetooth ? "/devices/virtual/misc/uhid" : "/devices/pci0000:00/usb1";
  const auto add = [&](const std::string& name, const std::string& lines) {
    path += name;
    paths_.push_back("/sys" + path);
    tree += "P: " + path + "\n" + lines + "\n";
  };
  if (!facts_.bluetooth) {
    if (port_ == 0 || facts_.wanders) port_ = number;
    add(formatted("/1-%d", port_),
        formatted("E: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=%04x\nA: idProduct=%04x\n", vendor,
                  product) +
            "A: manufacturer=Mock\nA: product=" + facts_.name + "\nA: bcdDevice=0100\n");
    add(formatted("/1-%d:1.0", port_),
        "E: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\n");
  }
  const std::string device =
      formatted("%04X:%04X:%04X.%04X", bus, vendor, product, static_cast<unsigned>(number));
  add("/" + device, "E: SUBSYSTEM=hid\n" + formatted("E: HID_ID=%04X:%08X:%08X\n", bus, vendor, product) +
                        "E: HID_NAME=" + facts_.name + "\nE: HID_PHYS=mock\nE: HID_UNIQ=" + facts_.serial +
                        "\n" + "H: report_descriptor=" + hex(facts_.descriptor) + "\n");
  const std::string named = "N: " + node + "\nE: DEVNAME=" + node_ + "\n";
  add("/hidraw/" + node, (facts_.named ? named : "") + "E: SUBSYSTEM=hidraw\n" +
                             formatted("E: MAJOR=240\nE: MINOR=%d\nA: dev=240:%d\n", number, number) +
                             "L: device=../../../" + device + "\n");
  {
    const std::lock_guard lock(mutex_);
    plugged_ = true;
    goes_ = false;
    bell_ = -1;
  }
  nodes_.push_back(node_);
  GError* error = nullptr;
  succeeds(umockdev_testbed_attach_ioctl(machine_.testbed_, node_.c_str(), handler_, &error) != FALSE, error);
  succeeds(umockdev_testbed_add_from_string(machine_.testbed_, tree.c_str(), &error) != FALSE, error);
  const std::lock_guard lock(mutex_);
  bell_ = umockdev_testbed_get_dev_fd(machine_.testbed_, node_.c_str());
  if (!said_.empty()) ring();  // it was said before the node had an end
}

void MockHid::unplug() {
  const std::lock_guard lock(mutex_);
  if (!plugged_) return;
  plugged_ = false;
  said_.clear();
  for (; !paths_.empty(); paths_.pop_back())
    umockdev_testbed_remove_device(machine_.testbed_, paths_.back().c_str());
  if (bell_ < 0) return;
  // The terminal's name is free again once this end is closed, but umockdev would stumble over it.
  char name[64];
  succeeds(ptsname_r(bell_, name, sizeof name) == 0, nullptr);
  std::string terminal = name;
  std::ranges::replace(terminal, '/', '_');
  gchar* const root = umockdev_testbed_get_root_dir(machine_.testbed_);
  unlink((std::string(root) + "/dev/.ptymap/" + terminal).c_str());
  g_free(root);
  // Whoever polls the node sees it hang up. The number of this end stays umockdev's, which closes it.
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nothing, bell_);
  close(nothing);
}

// The node is a terminal's end, on which reports would run together: it carries a byte that only wakes who
// polls it, and on_read() puts the report in its place.
void MockHid::ring() const {
  succeeds(write(bell_, "!", 1) == 1, nullptr);
}

void MockHid::say(Bytes report) {
  const std::lock_guard lock(mutex_);
  if (!plugged_) return;
  said_.push_back(std::move(report));
  if (said_.size() == 1 && bell_ >= 0) ring();
}

bool MockHid::all_read() const {
  const std::lock_guard lock(mutex_);
  return said_.empty();
}

void MockHid::take(bool takes) {
  const std::lock_guard lock(mutex_);
  takes_ = takes;
}

void MockHid::go() {
  const std::lock_guard lock(mutex_);
  goes_ = true;
}

Bytes MockHid::last_written() const {
  const std::lock_guard lock(mutex_);
  return written_.back();
}

MockHid::Clock::time_point MockHid::written_at(std::size_t n) const {
  const std::lock_guard lock(mutex_);
  return written_at_[n];
}

std::size_t MockHid::times_written() const {
  const std::lock_guard lock(mutex_);
  return written_.size();
}

std::vector<Bytes> MockHid::written() const {
  const std::lock_guard lock(mutex_);
  return written_;
}

std::vector<std::uint8_t> MockHid::asked() const {
  const std::lock_guard lock(mutex_);
  return asked_;
}

gboolean MockHid::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  static_cast<MockHid*>(self)->answer(client);
  return TRUE;
}

void MockHid::answer(UMockdevIoctlClient* client) {
  {
    const std::lock_guard lock(mutex_);
    if (!plugged_ || goes_) return umockdev_ioctl_client_complete(client, -1, ENODEV);
  }
  const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
  if (request == HIDIOCGRDESCSIZE) {
    fill(client, bytes_of(static_cast<int>(facts_.descriptor.size())));
    umockdev_ioctl_client_complete(client, 0, 0);
  } else if (request == HIDIOCGRDESC) {
    hidraw_report_descriptor descriptor{};
    descriptor.size = static_cast<__u32>(facts_.descriptor.size());
    std::ranges::copy(facts_.descriptor, descriptor.value);
    fill(client, bytes_of(descriptor));
    umockdev_ioctl_client_complete(client, 0, 0);
  } else if (_IOC_TYPE(request) == 'H' && _IOC_NR(request) == _IOC_NR(HIDIOCGFEATURE(0))) {
    answer_feature(client, _IOC_SIZE(request));
  } else {
    umockdev_ioctl_client_complete(client, -1, ENOTTY);
  }
}

void MockHid::answer_feature(UMockdevIoctlClient* client, std::size_t room) {
  GError* error = nullptr;
  UMockdevIoctlData* const asked =
      umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, room, &error);
  if (asked == nullptr) return umockdev_ioctl_client_complete(client, -1, EFAULT);
  const std::uint8_t number = asked->data[0];
  {
    const std::lock_guard lock(mutex_);
    asked_.push_back(number);
  }
  const auto feature = std::ranges::find(facts_.features, number, [](const Bytes& f) { return f.front(); });
  if (feature == facts_.features.end()) {
    umockdev_ioctl_client_complete(client, -1, EPIPE);
  } else {
    Bytes copy = *feature;
    copy.resize(std::min(copy.size(), room));
    umockdev_ioctl_data_update(asked, 0, copy.data(), static_cast<gint>(copy.size()));
    umockdev_ioctl_client_complete(client, static_cast<glong>(copy.size()), 0);
  }
  umockdev_ioctl_data_unref(asked);
}

gboolean MockHid::on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  MockHid& hid = *static_cast<MockHid*>(self);
  const std::lock_guard lock(hid.mutex_);
  if (!hid.plugged_ || hid.said_.empty()) {
    umockdev_ioctl_client_complete(client, -1, hid.plugged_ ? EAGAIN : EIO);
    return TRUE;
  }
  GError* error = nullptr;
  int why = 0;
  umockdev_ioctl_client_execute(client, &why, &error);  // takes the bell's byte off the node
  UMockdevIoctlData* const room = umockdev_ioctl_client_get_arg(client);
  Bytes report = std::move(hid.said_.front());
  hid.said_.pop_front();
  report.resize(std::min(report.size(), static_cast<std::size_t>(room->data_len)));
  umockdev_ioctl_data_update(room, 0, report.data(), static_cast<gint>(report.size()));
  if (!hid.said_.empty()) hid.ring();
  umockdev_ioctl_client_complete(client, static_cast<glong>(report.size()), 0);
  return TRUE;
}

gboolean MockHid::on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  MockHid& hid = *static_cast<MockHid*>(self);
  const std::lock_guard lock(hid.mutex_);
  if (!hid.plugged_ || !hid.takes_) {
    umockdev_ioctl_client_complete(client, -1, hid.plugged_ ? EPIPE : ENODEV);
    return TRUE;
  }
  const UMockdevIoctlData* const report = umockdev_ioctl_client_get_arg(client);
  hid.written_.emplace_back(report->data, report->data + report->data_len);
  hid.written_at_.push_back(Clock::now());
  umockdev_ioctl_client_complete(client, report->data_len, 0);
  return TRUE;
}

}  // namespace fulcrum::test
