#include "tests/drivers_mock/mock_usb.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace fulcrum::test {
namespace {

// The chip tells its line's state at times though it has nothing else to say.
constexpr int kIdleReaps = 16;

std::string text_of(const char* format, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string hex_of(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += text_of("%02X", byte);
  return text;
}

void need(bool done, const char* what) {
  if (done) return;
  std::fprintf(stderr, "umockdev refused: %s\n", what);
  std::abort();
}

UMockdevIoctlData* pointed_to(UMockdevIoctlData* data, std::size_t at, std::size_t length) {
  UMockdevIoctlData* const found = umockdev_ioctl_data_resolve(data, at, length, nullptr);
  need(found != nullptr, "to follow a pointer");
  return found;
}

template <class T>
void put(UMockdevIoctlData* data, std::size_t at, T value) {
  umockdev_ioctl_data_update(data, at, reinterpret_cast<guint8*>(&value), sizeof value);
}

// What an ioctl was given, which is an address.
gulong address_in(UMockdevIoctlClient* client) {
  gulong address = 0;
  std::memcpy(&address, umockdev_ioctl_client_get_arg(client)->data, sizeof address);
  return address;
}

usbdevfs_urb block_of(const UMockdevIoctlData* data) {
  usbdevfs_urb block;
  std::memcpy(&block, data->data, sizeof block);
  return block;
}

}  // namespace

MockUsb::MockUsb(MockMachine& machine, FalconModel& model, std::string serial, bool wanders)
    : machine_(machine),
      model_(model),
      handler_(umockdev_ioctl_base_new()),
      serial_(std::move(serial)),
      wanders_(wanders) {
  g_signal_connect_data(handler_, "handle-ioctl", reinterpret_cast<GCallback>(&MockUsb::on_ioctl), this,
                        nullptr, static_cast<GConnectFlags>(0));
  plug();
}

MockUsb::~MockUsb() {
  unplug();
  for (const std::string& node : nodes_)
    umockdev_testbed_detach_ioctl(machine_.testbed_, node.c_str(), nullptr);
  g_signal_handlers_disconnect_matched(handler_, G_SIGNAL_MATCH_DATA, 0, 0, nullptr, nullptr, this);
  g_object_unref(handler_);
  const std::lock_guard lock(mutex_);
  for (const Transfer& transfer : done_) {
    umockdev_ioctl_data_unref(transfer.buffer);
    umockdev_ioctl_data_unref(transfer.block);
  }
}

void MockUsb::plug() {
  const int number = machine_.next_number_++;
  node_ = text_of("/dev/bus/usb/001/%03d", number);
  if (port_ == 0 || wanders_) port_ = number;
  const std::string path = text_of("/devices/pci0000:00/usb1/1-%d", port_);
  Bytes descriptors = FalconModel::device_descriptor();
  const unsigned vendor = descriptors[8] + 256u * descriptors[9];
  const unsigned product = descriptors[10] + 256u * descriptors[11];
  const Bytes configuration = FalconModel::configuration_descriptor();
  descriptors.insert(descriptors.end(), configuration.begin(), configuration.end());
  const std::string device =
      "P: " + path + "\nN: " + node_.substr(5) + "=" + hex_of(descriptors) + "\nE: DEVNAME=" + node_ +
      "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: BUSNUM=001\n" +
      text_of("E: DEVNUM=%03d\nE: MAJOR=189\nE: MINOR=%d\nA: busnum=1\nA: devnum=%d\n", number, number - 1,
              number) +
      text_of("A: idVendor=%04x\nA: idProduct=%04x\nA: bConfigurationValue=1\nA: speed=12\n", vendor,
              product) +
      (serial_.empty() ? "" : "A: serial=" + serial_ + "\n") + "H: descriptors=" + hex_of(descriptors) + "\n";
  {
    const std::lock_guard lock(mutex_);
    plugged_ = true;
    claimed_ = false;
    path_ = "/sys" + path;
  }
  nodes_.push_back(node_);
  need(umockdev_testbed_attach_ioctl(machine_.testbed_, node_.c_str(), handler_, nullptr) != FALSE,
       "to answer for a node");
  need(umockdev_testbed_add_from_string(machine_.testbed_, device.c_str(), nullptr) != FALSE, device.c_str());
}

// As the kernel does it: what is under way comes back as shut down, and nothing more is taken.
void MockUsb::unplug() {
  const std::lock_guard lock(mutex_);
  if (!plugged_) return;
  plugged_ = false;
  finish_all(-ESHUTDOWN);
  umockdev_testbed_remove_device(machine_.testbed_, path_.c_str());
  gchar* const root = umockdev_testbed_get_root_dir(machine_.testbed_);
  unlink((root + node_).c_str());
  g_free(root);
}

void MockUsb::claim_elsewhere(bool claimed) {
  const std::lock_guard lock(mutex_);
  elsewhere_ = claimed;
}

void MockUsb::garble_in(bool garbles) {
  const std::lock_guard lock(mutex_);
  garbles_ = garbles;
}

bool MockUsb::is_claimed() const {
  const std::lock_guard lock(mutex_);
  return claimed_;
}

std::size_t MockUsb::live() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size() + done_.size();
}

gboolean MockUsb::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  static_cast<MockUsb*>(self)->answer(client);
  return TRUE;
}

void MockUsb::answer(UMockdevIoctlClient* client) {
  int error = ENOTTY;
  {
    const std::lock_guard lock(mutex_);
    switch (umockdev_ioctl_client_get_request(client)) {
      case USBDEVFS_GET_CAPABILITIES: {
        UMockdevIoctlData* const to = pointed_to(umockdev_ioctl_client_get_arg(client), 0, sizeof(guint32));
        put(to, 0, guint32{USBDEVFS_CAP_REAP_AFTER_DISCONNECT});
        umockdev_ioctl_data_unref(to);
        error = 0;
        break;
      }
      case USBDEVFS_CLAIMINTERFACE:
        error = claim(true);
        break;
      case USBDEVFS_RELEASEINTERFACE:
        error = claim(false);
        break;
      case USBDEVFS_SUBMITURB:
        error = submit(client);
        break;
      case USBDEVFS_DISCARDURB:
        error = discard(client);
        break;
      case USBDEVFS_REAPURB:
      case USBDEVFS_REAPURBNDELAY:
        error = reap(client);
        break;
      default:
        break;
    }
  }
  umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
}

int MockUsb::claim(bool claims) {
  if (!plugged_) return ENODEV;
  if (claims && (claimed_ || elsewhere_)) return EBUSY;
  if (!claims && !claimed_) return EINVAL;
  claimed_ = claims;
  return 0;
}

void MockUsb::finish(Transfer transfer, int status, const Bytes& read, int length) {
  if (!read.empty()) {
    Bytes copy = read;
    umockdev_ioctl_data_update(transfer.buffer, 0, copy.data(), static_cast<gint>(copy.size()));
  }
  put(transfer.block, offsetof(usbdevfs_urb, status), status);
  put(transfer.block, offsetof(usbdevfs_urb, actual_length), length);
  done_.push_back(transfer);
}

void MockUsb::finish_all(int status) {
  for (; !waiting_.empty(); waiting_.pop_front()) finish(waiting_.front(), status, {}, 0);
}

// Bulk transfers need the interface; requests to the device do not.
int MockUsb::submit(UMockdevIoctlClient* client) {
  if (!plugged_) return ENODEV;
  Transfer transfer{.address = address_in(client)};
  transfer.block = pointed_to(umockdev_ioctl_client_get_arg(client), 0, sizeof(usbdevfs_urb));
  const usbdevfs_urb block = block_of(transfer.block);
  transfer.buffer = pointed_to(transfer.block, offsetof(usbdevfs_urb, buffer),
                               static_cast<std::size_t>(block.buffer_length));
  const std::span<const std::uint8_t> bytes(transfer.buffer->data,
                                            static_cast<std::size_t>(block.buffer_length));
  if (block.type == USBDEVFS_URB_TYPE_CONTROL) {
    const auto word = [&](std::size_t at) { return bytes[at] + 256 * bytes[at + 1]; };
    const bool taken = model_.control(bytes[0], bytes[1], word(2), word(4));
    finish(transfer, taken ? 0 : -EPIPE, {}, 0);
  } else if (claimed_ && block.type == USBDEVFS_URB_TYPE_BULK && block.endpoint == 0x02) {
    model_.out(bytes);
    finish(transfer, 0, {}, block.buffer_length);
  } else if (claimed_ && block.type == USBDEVFS_URB_TYPE_BULK && block.endpoint == 0x81) {
    waiting_.push_back(transfer);
  } else {
    umockdev_ioctl_data_unref(transfer.buffer);
    umockdev_ioctl_data_unref(transfer.block);
    return ENOENT;
  }
  return 0;
}

int MockUsb::discard(UMockdevIoctlClient* client) {
  const auto found = std::ranges::find(waiting_, address_in(client), &Transfer::address);
  if (found == waiting_.end()) return EINVAL;
  finish(*found, -ENOENT, {}, 0);
  waiting_.erase(found);
  return 0;
}

int MockUsb::reap(UMockdevIoctlClient* client) {
  if (garbles_) finish_all(-EPROTO);
  if (!waiting_.empty() && (model_.has_more() || ++idle_reaps_ % kIdleReaps == 0)) {
    const Transfer transfer = waiting_.front();
    waiting_.pop_front();
    const Bytes said = model_.in();
    finish(transfer, 0, said, static_cast<int>(said.size()));
  }
  if (done_.empty()) return plugged_ ? EAGAIN : ENODEV;
  const Transfer transfer = done_.front();
  done_.pop_front();
  UMockdevIoctlData* const slot = pointed_to(umockdev_ioctl_client_get_arg(client), 0, sizeof(void*));
  umockdev_ioctl_data_set_ptr(slot, 0, transfer.block);
  umockdev_ioctl_data_unref(slot);
  umockdev_ioctl_data_unref(transfer.buffer);
  umockdev_ioctl_data_unref(transfer.block);
  return 0;
}

}  // namespace fulcrum::test
