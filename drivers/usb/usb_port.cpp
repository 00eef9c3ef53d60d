#include "drivers/usb/usb_port.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <utility>

#include "drivers/permission.h"
#include "drivers/usb/libusb_port.h"

namespace fulcrum::usb {
namespace {

// What is plugged in when it is made: a context of libusb's, and its list.
class Bus {
public:
  Bus() {
    if (libusb_init(&context_) != 0) context_ = nullptr;
    if (context_ != nullptr) count_ = std::max<ssize_t>(libusb_get_device_list(context_, &devices_), 0);
  }
  ~Bus() {
    if (devices_ != nullptr) libusb_free_device_list(devices_, 1);
    if (context_ != nullptr) libusb_exit(context_);
  }
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  std::span<libusb_device* const> devices() const { return {devices_, static_cast<std::size_t>(count_)}; }
  // Whoever has opened one of them keeps it.
  libusb_context* release() {
    libusb_free_device_list(std::exchange(devices_, nullptr), 1);
    return std::exchange(context_, nullptr);
  }

private:
  libusb_context* context_ = nullptr;
  libusb_device** devices_ = nullptr;
  ssize_t count_ = 0;
};

std::string node_of(int bus, int address) {
  char path[64];
  std::snprintf(path, sizeof path, "/dev/bus/usb/%03d/%03d", bus, address);
  return path;
}

// Bus and ports from there on.
std::string port_of(libusb_device* device) {
  std::array<std::uint8_t, 7> ports{};  // as deep as USB goes
  const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string name = std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < count; ++i)
    name.append(i == 0 ? "-" : ".").append(std::to_string(ports[static_cast<std::size_t>(i)]));
  return name;
}

// As the kernel has read it: libusb would have to open the device.
std::string serial_at(const std::string& port) {
  std::string serial;
  std::getline(std::ifstream("/sys/bus/usb/devices/" + port + "/serial"), serial);
  return serial;
}

Error cannot_open(const UsbPlace& place, int error) {
  if (error == LIBUSB_ERROR_ACCESS) return not_permitted(place.path);
  std::string sentence = "it is plugged in (";
  sentence.append(place.path);
  if (error == LIBUSB_ERROR_BUSY)
    sentence.append("), and another program holds it: close that one.");
  else
    sentence.append("), and cannot be opened (")
        .append(libusb_strerror(static_cast<libusb_error>(error)))
        .append("): plug it in again.");
  return Error{std::move(sentence)};
}

}  // namespace

std::vector<UsbPlace> find_usb(std::span<const hid::HidId> ids) {
  std::vector<UsbPlace> places;
  const Bus bus;
  for (libusb_device* const device : bus.devices()) {
    libusb_device_descriptor says{};
    if (libusb_get_device_descriptor(device, &says) != 0) continue;
    if (std::ranges::find(ids, hid::HidId{says.idVendor, says.idProduct}) == ids.end()) continue;
    UsbPlace place{.bus = libusb_get_bus_number(device), .address = libusb_get_device_address(device)};
    place.path = node_of(place.bus, place.address);
    place.permitted = access(place.path.c_str(), R_OK | W_OK) == 0;
    place.port = port_of(device);
    place.serial = serial_at(place.port);
    places.push_back(std::move(place));
  }
  std::ranges::sort(places, {}, &UsbPlace::path);
  return places;
}

Result<std::unique_ptr<UsbPort>> open_usb(const UsbPlace& place, const UsbEndpoints& endpoints) {
  Bus bus;
  const auto is_there = [&](libusb_device* device) {
    return libusb_get_bus_number(device) == place.bus && libusb_get_device_address(device) == place.address;
  };
  const auto found = std::ranges::find_if(bus.devices(), is_there);
  if (found == bus.devices().end()) return cannot_open(place, LIBUSB_ERROR_NO_DEVICE);
  libusb_device_handle* device = nullptr;
  if (const int error = libusb_open(*found, &device); error != 0) return cannot_open(place, error);
  if (const int error = libusb_claim_interface(device, endpoints.interface); error != 0) {
    libusb_close(device);
    return cannot_open(place, error);
  }
  return std::unique_ptr<UsbPort>(std::make_unique<LibusbPort>(bus.release(), device, endpoints));
}

}  // namespace fulcrum::usb
