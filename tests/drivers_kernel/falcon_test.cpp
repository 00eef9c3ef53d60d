// A Falcon on a kernel's own USB, by the real libusb: found, started with its firmware, homed, pushed against
// a wall, unplugged in contact and plugged in again.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "drivers/registry.h"
#include "tests/device_models/falcon_usb.h"
#include "tests/drivers_kernel/usbip_device.h"
#include "tests/drivers_kernel/wait_for.h"

namespace fulcrum::test {
namespace {

DeviceListing listed_falcon() {
  const std::vector<DeviceListing> devices = list_devices("no window");
  return *std::ranges::find(devices, "falcon", &DeviceListing::name);
}

// A wall before the base: what is further in than it is pushed out.
class HeldAtAWall {
public:
  static constexpr double kBegin = -0.01, kStiffness = 500;  // m, N/m

  explicit HeldAtAWall(Device& device) : device_(device) {}
  void tick() {
    const double depth = kBegin - device_.read().X_DH.p.z();
    DeviceCommand command;
    command.F_H_D.force = Vec3(0, 0, depth > 0 ? kStiffness * depth : 0);
    device_.write(command);
  }
  void until(auto seen) {
    wait_for([&] {
      tick();
      return seen();
    });
  }

private:
  Device& device_;
};

// Somebody pulls the grip out and pushes it in as long as that is asked for.
class HomingHand {
public:
  explicit HomingHand(FalconModel& falcon)
      : thread_([this, &falcon] {
          while (!ends_) {
            falcon.home();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
          }
        }) {}
  ~HomingHand() {
    ends_ = true;
    thread_.join();
  }
  HomingHand(const HomingHand&) = delete;
  HomingHand& operator=(const HomingHand&) = delete;

private:
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

TEST(KernelFalcon, IsHomedPushesAgainstAWallAndIsFoundAgain) {
  const std::filesystem::path firmware = "/tmp/falcon_firmware.bin";
  Bytes bytes(2000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i >> 3);
  std::ofstream(firmware, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  setenv("FULCRUM_FALCON_FIRMWARE", firmware.c_str(), 1);
  EXPECT_FALSE(listed_falcon().present);

  FalconModel falcon(bytes);
  FalconUsb usb(falcon);
  UsbipDevice plugged(usb);
  wait_for([] { return listed_falcon().present; });
  EXPECT_EQ(best_device("no window").name, "falcon");

  Result<OpenDevice> opened = [&] {
    const HomingHand hand(falcon);
    return open_device("falcon", {.desc = DeviceDesc{}, .X_DH = Pose{}});
  }();
  ASSERT_TRUE(opened) << opened.error().sentence;
  EXPECT_TRUE(falcon.runs());
  Device& device = *opened->device;
  HeldAtAWall held(device);

  falcon.hold({0.01, -0.02, 0});
  held.until([&] { return (device.read().X_DH.p - Vec3(0.01, -0.02, 0)).norm() < 1e-4; });
  EXPECT_LT(falcon.force_D().norm(), 0.02) << "before the wall";
  falcon.hold({0.01, -0.02, -0.015});
  const auto pushes = [&] { return (falcon.force_D() - Vec3(0, 0, 2.5)).norm() < 0.1; };
  held.until(pushes);

  plugged.unplug();
  wait_for([&] { return !device.read().connected; });
  falcon.switch_off_and_on();
  {
    const HomingHand hand(falcon);
    plugged.plug();
    wait_for([&] { return device.read().connected; });
  }
  held.until(pushes);
  wait_for([&] { return falcon.force_D().norm() < 1e-9; });  // nobody renews it
  held.until(pushes);
  opened->device.reset();
  EXPECT_EQ(falcon.motors(), (std::array<int, 3>{}));
}

}  // namespace
}  // namespace fulcrum::test
