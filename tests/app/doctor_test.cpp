// What `fulcrum doctor` makes of the kernel's files, in a folder that stands for /sys.

#include <gtest/gtest.h>

#include <fstream>

#include "engine/app/doctor/held_devices.h"
#include "engine/app/doctor/machine_files.h"
#include "engine/app/doctor/wake_ups.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

class Sys : public testing::Test {
protected:
  Sys() {
    std::string name = (fs::temp_directory_path() / "fulcrum_sys_XXXXXX").string();
    sys = mkdtemp(name.data());
  }
  ~Sys() override { fs::remove_all(sys); }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((sys / file).parent_path());
    std::ofstream(sys / file) << text << "\n";
  }
  fs::path sys;
};

TEST_F(Sys, WhatSlowsTheProcessorsIsNamedWithItsCure) {
  EXPECT_EQ(governor_of(sys).health, Health::good) << "a machine that does not tell";
  write("devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance");
  write("devices/system/cpu/online", "0-1");
  EXPECT_EQ(governor_of(sys).health, Health::good);
  EXPECT_EQ(governor_of(sys).cure, "");
  write("devices/system/cpu/cpu1/cpufreq/scaling_governor", "powersave");
  const Finding slow = governor_of(sys);
  EXPECT_EQ(slow.health, Health::fair);
  EXPECT_NE(slow.says.find("performance, powersave"), std::string::npos) << slow.says;
  EXPECT_NE(slow.cure.find("scaling_governor"), std::string::npos) << slow.cure;
}

TEST_F(Sys, OursMayNotSleepAndOthersDoNotMatter) {
  const auto ours = [](std::uint16_t vendor, std::uint16_t product) {
    return vendor == 0x256f && product == 0xc635;
  };
  EXPECT_EQ(usb_sleep_of(sys, ours).health, Health::good) << "a machine without USB";
  write("bus/usb/devices/1-1/idVendor", "0a12");
  write("bus/usb/devices/1-1/idProduct", "0001");
  write("bus/usb/devices/1-1/power/control", "auto");
  write("bus/usb/devices/1-0:1.0/bInterfaceClass", "03");
  write("bus/usb/devices/1-3/idVendor", "not a number");
  write("bus/usb/devices/1-3/idProduct", "c635");
  EXPECT_EQ(usb_sleep_of(sys, ours).health, Health::good);
  write("bus/usb/devices/1-2/idVendor", "256f");
  write("bus/usb/devices/1-2/idProduct", "c635");
  write("bus/usb/devices/1-2/power/control", "on");
  EXPECT_EQ(usb_sleep_of(sys, ours).health, Health::good);
  write("bus/usb/devices/1-2/power/control", "auto");
  const Finding sleepy = usb_sleep_of(sys, ours);
  EXPECT_EQ(sleepy.health, Health::fair);
  EXPECT_NE(sleepy.says.find("1-2"), std::string::npos) << sleepy.says;
  EXPECT_EQ(sleepy.says.find("1-1"), std::string::npos) << sleepy.says;
  EXPECT_EQ(sleepy.cure, "as root: echo on | tee " + (sys / "bus/usb/devices/1-2/power/control").string());
}

TEST(WakeUps, ASecondOfTicksIsMeasured) {
  const WakeUps wake_ups = measure_wake_ups();
  EXPECT_GT(wake_ups.worst_s, 0);
  EXPECT_GE(wake_ups.late, 0);
  EXPECT_LE(wake_ups.late, 1000);
  EXPECT_EQ(wake_ups.late > 0, wake_ups.worst_s >= 1e-3);
}

// Whatever its driver's words are: what counts is whether its node may be opened.
TEST(HeldDevices, WhatIsThereAndMayNotBeOpenedIsNamedWithItsCure) {
  const DeviceListing mouse{.name = "mouse", .what = "a mouse", .present = true};
  const DeviceListing cap{.name = "cap", .what = "a cap", .present = true, .permitted = true};
  DeviceListing arm{.name = "arm", .what = "an arm", .reason = "its node is not yours.", .permitted = false};
  const Finding found = devices_in({mouse, arm, cap}, cap);
  EXPECT_EQ(found.health, Health::bad);
  EXPECT_EQ(found.says, "arm: its node is not yours.");
  EXPECT_NE(found.cure.find("tools/run --udev"), std::string::npos);
  // Of a device without a node its reason alone tells, and no rule for udev helps.
  arm.permitted.reset();
  arm.reason = "you may not open its service.";
  EXPECT_EQ(devices_in({mouse, arm, cap}, cap).health, Health::good);
  EXPECT_EQ(devices_in({mouse, arm, cap}, cap).says, "A run takes cap, a cap.");
  EXPECT_EQ(devices_in({mouse, arm}, mouse).health, Health::fair);
  EXPECT_EQ(devices_in({arm}, arm).health, Health::fair);
}

}  // namespace
}  // namespace fulcrum::app
