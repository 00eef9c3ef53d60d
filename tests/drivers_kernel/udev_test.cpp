// The rules that are shipped, by the daemon that a person's system has: systemd-udevd, in a machine of its
// own.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "drivers/hid/hid_port.h"
#include "drivers/registry.h"
#include "tests/device_models/dualsense_model.h"
#include "tests/device_models/falcon_model.h"
#include "tests/device_models/falcon_usb.h"
#include "tests/device_models/spacemouse_model.h"
#include "tests/device_models/usb_hid.h"
#include "tests/drivers_kernel/uhid_device.h"
#include "tests/drivers_kernel/usbip_device.h"
#include "tests/drivers_kernel/wait_for.h"

namespace fulcrum::test {
namespace {

namespace fs = std::filesystem;

// The daemon, from the rules' folder onwards, until the test ends.
class Udev {
public:
  Udev() {
    fs::create_directories("/run/udev/rules.d");
    std::ofstream("/run/udev/rules.d/70-fulcrum.rules") << udev_rules();
    process_ = ::fork();
    if (process_ == 0) {
      ::execl("/bin/udevadm", "systemd-udevd", static_cast<char*>(nullptr));
      ::_exit(127);
    }
    // It listens to the kernel later than it can be asked, and answers once it does.
    wait_for([this] { return fs::exists("/run/udev/control") || !runs(); });
    wait_for([this] { return asked("control", "--ping") || !runs(); });
  }
  ~Udev() {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    fs::remove_all("/run/udev");
  }
  Udev(const Udev&) = delete;
  Udev& operator=(const Udev&) = delete;

  // Until it has dealt with all that the kernel has told it so far.
  bool settles() const { return asked("settle", nullptr); }

  bool runs() const { return ::waitpid(process_, nullptr, WNOHANG) == 0; }

private:
  static bool asked(const char* what, const char* how) {
    const pid_t asks = ::fork();
    if (asks == 0) {
      ::execl("/bin/udevadm", "udevadm", what, how, static_cast<char*>(nullptr));
      ::_exit(127);
    }
    int status = -1;
    return ::waitpid(asks, &status, 0) == asks && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  pid_t process_ = -1;
};

mode_t mode_of(const std::string& node) {
  struct stat status {};
  return ::stat(node.c_str(), &status) == 0 ? status.st_mode & 0777 : 0;
}

// Whether logind would give the person at the seat this node.
bool is_for_the_seat(const std::string& node) {
  struct stat status {};
  if (::stat(node.c_str(), &status) != 0) return false;
  const std::string number =
      "c" + std::to_string(major(status.st_rdev)) + ":" + std::to_string(minor(status.st_rdev));
  return fs::exists("/run/udev/tags/uaccess/" + number);
}

std::string node_of(const hid::HidId& id) {
  const std::vector<hid::HidPlace> places = hid::find_hid(std::array{id});
  return places.empty() ? "" : places[0].path;
}

void expect_opened(const hid::HidId& id) {
  wait_for([&] { return !node_of(id).empty(); });
  const std::string node = node_of(id);
  wait_for([&] { return is_for_the_seat(node); });
  EXPECT_EQ(mode_of(node), 0660U) << node;
}

TEST(UdevRules, OpenACapByUsb) {
  const Udev udev;
  SpaceMouseModel cap;
  UsbHid usb(cap, {.speed = UsbSpeed::full, .interval = 8, .hears_by_interrupt = false});
  const UsbipDevice plugged(usb);
  expect_opened(cap.facts().id);
  EXPECT_TRUE(udev.runs());
}

// By Bluetooth a node's numbers are in the name of the device above it, and nowhere else.
TEST(UdevRules, OpenAPadByBluetooth) {
  const Udev udev;
  DualSenseModel pad(DualSenseModel::Bus::bluetooth, 0x0224);
  const UhidDevice plugged(pad);
  expect_opened(pad.facts().id);
}

// A Falcon is no HID device: the node is that of its USB device itself.
TEST(UdevRules, OpenAFalcon) {
  const Udev udev;
  FalconModel falcon(Bytes(1000, 0x55));
  FalconUsb usb(falcon);
  const UsbipDevice plugged(usb);
  const auto node = [] {
    const std::vector<DeviceListing> all = list_devices("no window");
    const auto found = std::ranges::find(all, "falcon", &DeviceListing::name);
    return found == all.end() ? std::string() : found->node;
  };
  wait_for([&] { return !node().empty() && is_for_the_seat(node()); });
  EXPECT_EQ(mode_of(node()), 0660U) << node();
}

// A cap of nobody's: by a number that is for trials, and not the one that strips have.
class Stranger final : public HidModel {
public:
  static constexpr hid::HidId kId{0x1209, 0x0002};
  Stranger() : HidModel({kId, "Nobody", "Cap", SpaceMouseModel().facts().descriptor}) {}
  std::optional<Bytes> say() override { return std::nullopt; }
};

// What no rule names stays as the kernel made it.
TEST(UdevRules, OpenNothingElse) {
  const Udev udev;
  Stranger cap;
  UsbHid usb(cap, {.speed = UsbSpeed::full, .interval = 8, .hears_by_interrupt = false});
  const UsbipDevice plugged(usb);
  wait_for([] { return !node_of(Stranger::kId).empty(); });
  const std::string node = node_of(Stranger::kId);
  ASSERT_TRUE(udev.settles());
  EXPECT_FALSE(is_for_the_seat(node));
  EXPECT_NE(mode_of(node), 0660U) << node;
}

}  // namespace
}  // namespace fulcrum::test
