// The drivers on a kernel's own USB, HID and hidraw: models of devices are plugged into it, and found, read,
// unplugged and plugged in again as those that a person owns. The program runs in a machine of its own
// (machine.sh).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "drivers/hid/hid_port.h"
#include "drivers/registry.h"
#include "tests/device_models/dualsense_model.h"
#include "tests/device_models/spacemouse_model.h"
#include "tests/device_models/usb_hid.h"
#include "tests/drivers_kernel/uhid_device.h"
#include "tests/drivers_kernel/usbip_device.h"
#include "tests/drivers_kernel/wait_for.h"

namespace fulcrum::test {
namespace {

constexpr UsbHidFacts kCap{.speed = UsbSpeed::full, .interval = 8, .hears_by_interrupt = false};
constexpr UsbHidFacts kPad{.speed = UsbSpeed::high, .interval = 6, .hears_by_interrupt = true};

DeviceListing listed(const std::string& name) {
  const std::vector<DeviceListing> all = list_devices("no window");
  const auto found = std::ranges::find(all, name, &DeviceListing::name);
  return found == all.end() ? DeviceListing{} : *found;
}

bool present(const std::string& name) {
  return listed(name).present;
}

DeviceOrder order() {
  DeviceDesc desc = MouseDevice::mouse_desc();
  desc.vibrotactile = {{{.name = "left", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.04},
                        {.name = "right", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.02}}};
  return {.desc = desc, .signal = VibrotactileSignal{.largest = 20}, .X_DH = Pose{}};
}

// The last report that asks for rumble, without those by which the kernel sets lights.
Bytes last_rumble(const HidModel& pad, std::size_t flags) {
  const std::vector<Bytes> heard = pad.heard();
  const auto asks = [&](const Bytes& report) { return report.size() > flags && (report[flags] & 0x02) != 0; };
  const auto found = std::find_if(heard.rbegin(), heard.rend(), asks);
  return found == heard.rend() ? Bytes() : *found;
}

TEST(Kernel, WithoutDevicesNoneIsFound) {
  EXPECT_FALSE(present("spacemouse"));
  EXPECT_FALSE(present("dualsense"));
  EXPECT_NE(listed("spacemouse").reason.find("none is plugged in"), std::string::npos);
}

TEST(Kernel, SpaceMouseIsFoundAndEachOfItsAxesArrives) {
  SpaceMouseModel cap;
  UsbHid usb(cap, kCap);
  UsbipDevice plugged(usb);
  wait_for([] { return present("spacemouse"); });
  const std::vector<hid::HidPlace> places = hid::find_hid(std::array{cap.facts().id});
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].product, "SpaceMouse Compact");
  EXPECT_FALSE(places[0].bluetooth);
  EXPECT_EQ(best_device("no window").name, "spacemouse");

  const Result<OpenDevice> open = open_device("spacemouse", order());
  ASSERT_TRUE(open) << open.error().sentence;
  Device& device = *open->device;
  // From the device's axes into right, up, toward the person.
  const std::array<Vec3, 3> along{Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()};
  for (std::size_t axis = 0; axis < 6; ++axis) {
    std::array<int, 6> readings{};
    readings[axis] = SpaceMouseModel::kFull;
    const Pose from = device.read().X_DH;
    cap.push(readings);
    const Vec3& wanted = along[axis % 3];
    wait_for([&] {
      const Pose to = device.read().X_DH;
      const Vec3 moved = axis < 3 ? Vec3(to.p - from.p) : Vec3(2 * (to.q * from.q.conjugate()).vec());
      return moved.dot(wanted) > 0.01 && (moved - moved.dot(wanted) * wanted).norm() < 1e-3;
    });
    cap.push({});
    // Let go, it comes to rest.
    wait_for([&] {
      const Pose before = device.read().X_DH, after = device.read().X_DH;
      return (after.p - before.p).norm() < 1e-9 && after.q.angularDistance(before.q) < 1e-7;
    });
  }
  cap.press(2);
  wait_for([&] { return device.read().buttons == 2; });
}

TEST(Kernel, UnpluggedItSaysSoAndPluggedInAgainItGoesOn) {
  SpaceMouseModel cap;
  UsbHid usb(cap, kCap);
  UsbipDevice plugged(usb);
  wait_for([] { return present("spacemouse"); });
  const Result<OpenDevice> open = open_device("spacemouse", order());
  ASSERT_TRUE(open) << open.error().sentence;
  Device& device = *open->device;
  for (int time = 0; time < 3; ++time) {
    const double from = device.read().X_DH.p.x();
    cap.push({SpaceMouseModel::kFull});
    wait_for([&] { return device.read().X_DH.p.x() > from + 0.01; });
    plugged.unplug();
    wait_for([&] { return !device.read().connected; });
    EXPECT_FALSE(present("spacemouse"));
    cap.push({});
    plugged.plug();
    wait_for([&] { return device.read().connected; });
  }
}

TEST(Kernel, ThePadsSticksMoveIt) {
  DualSenseModel pad(DualSenseModel::Bus::usb, 0x0224);
  UsbHid usb(pad, kPad);
  UsbipDevice plugged(usb);
  wait_for([] { return present("dualsense"); });
  const Result<OpenDevice> open = open_device("dualsense", order());
  ASSERT_TRUE(open) << open.error().sentence;
  pad.tilt({255, 128, 128, 128});
  wait_for([&] { return open->device->read().X_DH.p.x() > 0.01; });
  EXPECT_EQ(open->device->read().X_DH.p.y(), 0);
}

TEST(Kernel, SpaceMouseMovesAndDualSenseVibratesBeside) {
  SpaceMouseModel cap;
  DualSenseModel pad(DualSenseModel::Bus::usb, 0x0224);
  UsbHid usb_cap(cap, kCap), usb_pad(pad, kPad);
  UsbipDevice plugged_cap(usb_cap), plugged_pad(usb_pad);
  wait_for([] { return present("spacemouse") && present("dualsense"); });
  Result<OpenDevice> open = open_device("spacemouse+dualsense", order());
  ASSERT_TRUE(open) << open.error().sentence;
  cap.push({SpaceMouseModel::kFull});
  wait_for([&] { return open->device->read().X_DH.p.x() > 0.01; });
  DeviceCommand command;
  command.vibrotactile.level = {20, 10};
  wait_for([&] {
    open->device->write(command);
    const Bytes told = last_rumble(pad, 1);
    return !told.empty() && told[3] == 128 && told[4] == 255;
  });
  EXPECT_TRUE(open->device->read().connected);
  plugged_pad.unplug();
  wait_for([&] { return !open->device->read().connected; });
  plugged_pad.plug();
  wait_for([&] { return open->device->read().connected; });
  open->device.reset();
  wait_for([&] {
    const Bytes told = last_rumble(pad, 1);
    return told[3] == 0 && told[4] == 0;
  });
}

}  // namespace
}  // namespace fulcrum::test
