// A Falcon's driver by the real libusb and libudev, on a model of the device behind a node of usbfs that
// umockdev stands in for. Whatever is waited for is waited for until it is seen: no clock decides.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "drivers/registry.h"
#include "tests/drivers_mock/mock_devices.h"
#include "tests/drivers_mock/mock_usb.h"
#include "tests/drivers_mock/privileges.h"

namespace fulcrum::test {
namespace {

Bytes falcon_firmware() {
  Bytes bytes(5000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i >> 3);
  return bytes;
}

DeviceCommand push_of(const Vec3& force) {
  DeviceCommand command;
  command.F_H_D.force = force;
  return command;
}

class FalconMock : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(machine.stands_in()) << "begin it by umockdev-wrapper";
    folder = std::filesystem::temp_directory_path() / ("falcon_mock_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "fulcrum");
    // NOLINTBEGIN(concurrency-mt-unsafe): no thread of a device runs yet.
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
    unsetenv("FULCRUM_FALCON_FIRMWARE");
    // NOLINTEND(concurrency-mt-unsafe)
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void bring_firmware() const {
    const Bytes bytes = falcon_firmware();
    std::ofstream(folder / "fulcrum" / "falcon_firmware.bin", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  static DeviceListing listed() {
    const std::vector<DeviceListing> devices = list_devices("no window");
    return *std::ranges::find(devices, "falcon", &DeviceListing::name);
  }
  static Result<OpenDevice> open() { return open_device("falcon", {.desc = DeviceDesc{}, .X_DH = Pose{}}); }
  // Somebody pulls the grip out and pushes it in as long as that is asked for.
  static Result<OpenDevice> open_homed(FalconModel& model) {
    std::atomic<bool> ends{false};
    std::thread hand([&] {
      while (!ends && !model.home()) std::this_thread::yield();
    });
    Result<OpenDevice> opened = open();
    ends = true;
    hand.join();
    return opened;
  }

  MockMachine machine;
  std::filesystem::path folder;
};

TEST_F(FalconMock, WhereNoneIsPluggedInThatIsSaid) {
  EXPECT_FALSE(listed().present);
  EXPECT_NE(listed().reason.find("plug one in"), std::string::npos) << listed().reason;
}

TEST_F(FalconMock, OneWithoutFirmwareSaysWhereToPutIt) {
  FalconModel model(falcon_firmware());
  MockUsb usb(machine, model);
  const DeviceListing falcon = listed();
  EXPECT_FALSE(falcon.present);
  EXPECT_NE(falcon.reason.find((folder / "fulcrum" / "falcon_firmware.bin").string()), std::string::npos)
      << falcon.reason;
  EXPECT_FALSE(usb.is_claimed()) << "it is given back";
  EXPECT_EQ(usb.live(), 0u);
  bring_firmware();
  EXPECT_TRUE(listed().present) << listed().reason;
  EXPECT_EQ(best_device("").name, "falcon");
}

TEST_F(FalconMock, FirmwareThatRunsNeedsNoFile) {
  FalconModel model(falcon_firmware(), true);
  MockUsb usb(machine, model);
  EXPECT_TRUE(listed().present) << listed().reason;
  EXPECT_EQ(listed().permitted, true);
  EXPECT_EQ(listed().node, usb.node());
  EXPECT_TRUE(model.runs());
}

TEST_F(FalconMock, WhatMayNotBeOpenedIsSaidWithItsCure) {
  FalconModel model(falcon_firmware(), true);
  MockUsb usb(machine, model);
  bring_firmware();
  ASSERT_EQ(chmod(usb.node().c_str(), 0), 0);
  bool forbidden = false;
  DeviceListing falcon;
  std::thread([&] {
    forbidden = open_by_modes_alone() && access(usb.node().c_str(), R_OK) != 0;
    if (forbidden) falcon = listed();
  }).join();
  if (!forbidden) GTEST_SKIP() << "this system lets whoever runs the tests open a node of mode 0";
  EXPECT_FALSE(falcon.present);
  EXPECT_EQ(falcon.permitted, false);
  for (const std::string& part : {usb.node(), std::string("tools/run --udev")})
    EXPECT_NE(falcon.reason.find(part), std::string::npos) << falcon.reason;
}

TEST_F(FalconMock, WhatIsHeldElsewhereIsSaid) {
  FalconModel model(falcon_firmware(), true);
  MockUsb usb(machine, model);
  bring_firmware();
  usb.claim_elsewhere(true);
  const auto held = open();
  ASSERT_FALSE(held);
  EXPECT_NE(held.error().sentence.find("another program holds it"), std::string::npos)
      << held.error().sentence;
  usb.claim_elsewhere(false);
  EXPECT_EQ(usb.live(), 0u);
}

TEST_F(FalconMock, ItIsNotPushedUntilItIsHomed) {
  FalconModel model(falcon_firmware(), true);
  MockUsb usb(machine, model);
  const auto refused = open();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("pull the grip out"), std::string::npos)
      << refused.error().sentence;
  EXPECT_EQ(model.lights() & 9u, 9u) << "homing, and red";
  EXPECT_FALSE(usb.is_claimed());
  EXPECT_EQ(usb.live(), 0u);
}

TEST_F(FalconMock, FromColdItIsStartedPushesAgainstAWallAndIsFoundAgain) {
  bring_firmware();
  FalconModel model(falcon_firmware());
  MockUsb usb(machine, model);
  auto opened = open_homed(model);
  ASSERT_TRUE(opened) << opened.error().sentence;
  EXPECT_TRUE(model.runs());
  Device& device = *opened->device;

  // A wall before the base: what is further in than it is pushed out, 500 N/m.
  const auto wall = [&] {
    const double depth = -0.01 - device.read().X_DH.p.z();
    device.write(push_of({0, 0, depth > 0 ? 500 * depth : 0}));
  };
  model.hold({0.01, -0.02, 0});
  wait_for([&] {
    wall();
    return (device.read().X_DH.p - Vec3(0.01, -0.02, 0)).norm() < 1e-4;
  });
  EXPECT_LT(model.force_D().norm(), 0.02);
  model.hold({0.01, -0.02, -0.015});
  wait_for([&] {
    wall();
    return (model.force_D() - Vec3(0, 0, 2.5)).norm() < 0.1;
  });
  EXPECT_EQ(model.lights(), 2u) << "green";

  usb.unplug();
  wait_for([&] { return !device.read().connected; });
  model.switch_off_and_on();
  usb.plug();
  std::atomic<bool> back{false};
  std::thread hand([&] {
    while (!back) {
      model.home();
      std::this_thread::yield();
    }
  });
  wait_for([&] { return device.read().connected; });
  back = true;
  hand.join();
  wait_for([&] {
    wall();
    return (model.force_D() - Vec3(0, 0, 2.5)).norm() < 0.1;
  });
  // Nobody renews it; and at the end it rests.
  wait_for([&] { return model.force_D().norm() < 1e-9; });
  wait_for([&] {
    wall();
    return model.force_D().z() > 2;
  });
  opened->device.reset();
  EXPECT_EQ(model.motors(), (std::array<int, 3>{}));
  EXPECT_FALSE(usb.is_claimed());
  EXPECT_EQ(usb.live(), 0u);
}

// Silent in contact: the force that was there goes by the next packet, and the sample grows old.
TEST_F(FalconMock, OneThatFallsSilentIsLetGo) {
  FalconModel model(falcon_firmware(), true);
  MockUsb usb(machine, model);
  auto opened = open_homed(model);
  ASSERT_TRUE(opened) << opened.error().sentence;
  wait_for([&] {
    opened->device->write(push_of({2, 0, 0}));
    return model.force_D().x() > 1.9;
  });
  model.have(FalconModel::Fault::silent);
  wait_for([&] {
    opened->device->write(push_of({2, 0, 0}));
    return model.motors() == std::array<int, 3>{};
  });
  wait_for([&] { return opened->device->read().age > 0.02; });
  EXPECT_TRUE(opened->device->read().connected);
  model.have(FalconModel::Fault::none);
  wait_for([&] { return opened->device->read().age < 0.02; });
}

// A bad cable: what it says is lost on the way, and it still hears. It is not taken again before the test has
// seen what it was told last.
TEST_F(FalconMock, OneWhoseRepliesAreDamagedIsToldToRestAndIsLost) {
  FalconModel model(falcon_firmware(), true);
  MockUsb usb(machine, model);
  auto opened = open_homed(model);
  ASSERT_TRUE(opened) << opened.error().sentence;
  std::atomic<bool> renews{true};
  std::thread hand([&] {
    while (renews) opened->device->write(push_of({2, 0, 0}));
  });
  wait_for([&] { return model.force_D().x() > 1.9; });
  usb.claim_elsewhere(true);
  usb.garble_in(true);
  wait_for([&] { return !usb.is_claimed(); });
  EXPECT_EQ(model.motors(), (std::array<int, 3>{}));
  EXPECT_FALSE(opened->device->read().connected);
  usb.garble_in(false);
  usb.claim_elsewhere(false);
  wait_for([&] { return opened->device->read().connected && model.force_D().x() > 1.9; });
  renews = false;
  hand.join();
}

// Two of them: whichever is listed first, the run goes on with its own, by its serial number at whatever
// port, or by its port. What it would be taken for was there before, and is listed before it.
TEST_F(FalconMock, PluggedInAgainItIsTheRunsOwn) {
  for (const bool numbered : {true, false}) {
    FalconModel model(falcon_firmware(), true), another(falcon_firmware(), true);
    MockUsb usb(machine, model, numbered ? "FN1" : "", numbered);
    MockUsb beside(machine, another, numbered ? "FN2" : "");
    model.hold({0.02, 0, 0});
    auto opened = open_homed(model);
    ASSERT_TRUE(opened) << opened.error().sentence;
    ASSERT_TRUE(usb.is_claimed());
    usb.unplug();
    wait_for([&] { return !opened->device->read().connected; });
    usb.plug();
    wait_for([&] { return opened->device->read().connected || beside.is_claimed(); });
    EXPECT_FALSE(beside.is_claimed()) << numbered;
    EXPECT_EQ(another.packets(), 0) << numbered;
    EXPECT_TRUE(usb.is_claimed()) << numbered;
  }
}

}  // namespace
}  // namespace fulcrum::test
