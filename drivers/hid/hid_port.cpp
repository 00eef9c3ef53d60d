#include "drivers/hid/hid_port.h"

#include <fcntl.h>
#include <hidapi.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

#include "drivers/permission.h"

namespace fulcrum::hid {
namespace {

// hidapi's own state is made once, whichever thread comes first.
bool ready() {
  static const bool good = hid_init() == 0;
  return good;
}

// hidapi keeps what went wrong last in a global, which enumerating, opening and closing free.
std::mutex& listing() {
  static std::mutex mutex;
  return mutex;
}

// One end that is read and one that is written: hidapi keeps what went wrong last with a device where two
// threads would free it twice.
class HidapiPort final : public HidPort {
public:
  HidapiPort(hid_device* in, hid_device* out) : in_(in), out_(out) {}
  ~HidapiPort() override {
    const std::lock_guard lock(listing());
    hid_close(in_);
    hid_close(out_);
  }

  int read(std::span<std::uint8_t> report, int wait_ms) override {
    return hid_read_timeout(in_, report.data(), report.size(), wait_ms);
  }
  bool write(std::span<const std::uint8_t> report) override {
    return hid_write(out_, report.data(), report.size()) >= 0;
  }
  int read_feature(std::span<std::uint8_t> feature) override {
    return hid_get_feature_report(in_, feature.data(), feature.size());
  }

private:
  hid_device *in_, *out_;
};

// hidapi 0.13 touches what it has freed where a node opens and then does not answer.
bool answers(const std::string& node) {
  const int file = open(node.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  int size = 0;
  const bool good = ioctl(file, HIDIOCGRDESCSIZE, &size) >= 0;
  close(file);
  return good;
}

std::string narrow(const wchar_t* text) {
  std::string narrowed;
  for (; text != nullptr && *text != 0; ++text)
    narrowed += *text >= 32 && *text < 127 ? static_cast<char>(*text) : '?';
  return narrowed;
}

// Where it is in sysfs, such as /sys/devices/pci0000:00/.../usb1/1-2/1-2:1.0/0003:054C:0CE6.0001; empty where
// that is not known.
std::string device_of(const std::string& node) {
  std::error_code error;
  const auto device =
      std::filesystem::canonical("/sys/class/hidraw/" + node.substr(node.rfind('/') + 1) + "/device", error);
  return error ? "" : device.string();
}

// The bus is the first number of the name.
bool is_bluetooth(const std::string& device) {
  return device.substr(device.rfind('/') + 1).starts_with("0005:");
}

// The folder before that of the interface: "1-2" of .../1-2/1-2:1.0/...
std::string port_of(const std::string& device) {
  const std::filesystem::path interface = std::filesystem::path(device).parent_path();
  const std::string name = interface.filename().string(), port = interface.parent_path().filename().string();
  return name.starts_with(port + ":") ? port : "";
}

constexpr unsigned short kGenericDesktop = 1, kVendors = 0xFF00;
constexpr unsigned short kJoystick = 4, kGamepad = 5, kMultiAxis = 8;

bool reports_axes(const hid_device_info& info) {
  if (info.usage_page == 0) return true;  // where it is not known
  return info.usage_page == kGenericDesktop &&
         (info.usage == kJoystick || info.usage == kGamepad || info.usage == kMultiAxis);
}

bool is_of(const hid_device_info& info, Nodes nodes) {
  return nodes == Nodes::all || (nodes == Nodes::of_axes ? reports_axes(info) : info.usage_page == kVendors);
}

}  // namespace

std::vector<HidPlace> find_hid(std::span<const HidId> ids, Nodes nodes) {
  std::vector<HidPlace> places;
  if (!ready()) return places;
  const std::lock_guard lock(listing());
  // hidapi 0.13 can crash on a device that is unplugged while it lists it. It is asked for our vendors'
  // devices alone, so that nobody else's can cause that.
  std::set<std::uint16_t> vendors;
  for (const HidId& id : ids) vendors.insert(id.vendor);
  for (const std::uint16_t vendor : vendors) {
    hid_device_info* const all = hid_enumerate(vendor, 0);
    for (const hid_device_info* info = all; info != nullptr; info = info->next) {
      const HidId id{info->vendor_id, info->product_id};
      if (std::ranges::find(ids, id) == ids.end()) continue;
      if (!is_of(*info, nodes)) continue;
      if (info->path == nullptr) continue;  // it is being unplugged
      const std::string path = info->path;
      const bool known = std::ranges::any_of(places, [&](const HidPlace& p) { return p.path == path; });
      if (known) continue;  // hidapi lists a node once for each of its usages
      const std::string device = device_of(path);
      places.push_back({id, path, is_bluetooth(device), narrow(info->product_string),
                        access(path.c_str(), R_OK | W_OK) == 0, info->release_number,
                        narrow(info->serial_number), port_of(device)});
    }
    hid_free_enumeration(all);
  }
  std::ranges::sort(places, {}, &HidPlace::path);
  return places;
}

Result<std::unique_ptr<HidPort>> open_hid(const HidPlace& place) {
  if (access(place.path.c_str(), R_OK | W_OK) != 0) {
    const int why = errno;
    if (why == EACCES) return not_permitted(place.path);
    return Error{place.path + " cannot be opened (" + std::generic_category().message(why) +
                 "): plug the device in again."};
  }
  const std::lock_guard lock(listing());
  hid_device* const in = answers(place.path) ? hid_open_path(place.path.c_str()) : nullptr;
  hid_device* const out = in != nullptr ? hid_open_path(place.path.c_str()) : nullptr;
  if (out == nullptr) {
    hid_close(in);  // which takes null, too
    return Error{place.path + " cannot be opened by hidapi: close what else holds it, or plug it in again."};
  }
  return std::unique_ptr<HidPort>(std::make_unique<HidapiPort>(in, out));
}

}  // namespace fulcrum::hid
