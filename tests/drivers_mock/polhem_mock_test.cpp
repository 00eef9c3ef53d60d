// A Polhem by the real hidapi: its emulated board answers what it hears.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

#include "drivers/registry.h"
#include "tests/drivers_mock/mock_devices.h"

namespace fulcrum::test {
namespace {

// Seven numbers, low byte first, as the board of a Polhem says and hears them; its descriptor is a vendor's
// own.
Bytes board_report(const std::array<int, 7>& numbers) {
  Bytes report;
  for (const int number : numbers) {
    report.push_back(static_cast<std::uint8_t>(number & 255));
    report.push_back(static_cast<std::uint8_t>(number >> 8 & 255));
  }
  return report;
}

MockHidFacts polhem() {
  return {.id = {0x1234, 0x0006},
          .name = "mbed",
          .descriptor = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x75, 0x08, 0x95, 0x0E,
                         0x09, 0x01, 0x81, 0x02, 0x95, 0x0E, 0x09, 0x01, 0x91, 0x02, 0xC0}};
}

// Of content/devices/polhem.yaml, as far as its driver needs it.
DeviceDesc polhem_desc() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.mechanism.q_DK = Quat(0.5, -0.5, -0.5, -0.5);
  desc.mechanism.arms = {
      {"arm",
       {{.name = "yaw", .axis_K = {0, 0, 1}, .max_torque = 1.936},
        {.name = "shoulder", .axis_K = {0, -1, 0}, .point_K = {0, 0, 0.058}, .home = -0.4393498},
        {.name = "elbow",
         .axis_K = {0, -1, 0},
         .point_K = {0, 0, 0.232},
         .home = 0.9585170,
         .through_parallelogram = true}},
       Vec3(0, 0, 0.099)}};
  return desc;
}

TEST_F(Mock, APolhemIsPushedWithAndLetGo) {
  MockHid board(machine, polhem());
  for (const DeviceListing& device : list_devices("no window"))
    if (device.name == "polhem") EXPECT_TRUE(device.present) << device.reason;
  EXPECT_EQ(best_device("").name, "polhem");

  // It answers what it hears, while it is plugged in.
  std::atomic<bool> on{true}, plugged{true}, asks{true};  // its button was pressed
  std::atomic<std::size_t> answered{0};
  std::atomic<int> yaw{100};
  std::thread firmware([&] {
    for (; on; std::this_thread::yield()) {
      const std::size_t heard = board.times_written();
      if (!plugged || heard == answered || !board.all_read()) continue;
      answered = heard;
      if (board.written().back()[7] == 1) asks = false;
      board.say(board_report({yaw, 0, -4000, 0, 0, 0, asks ? 1 : 0}));
    }
  });
  auto open = open_device("polhem", {.desc = polhem_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(open) << open.error().sentence;
  const Vec3 at = open->device->read().X_DH.p;
  yaw = 1000;
  wait_for([&] { return (open->device->read().X_DH.p - at).norm() > 0.01; });
  EXPECT_TRUE(open->device->read().connected);

  DeviceCommand push;
  push.effort[0] = 1;
  const auto current = [](const Bytes& heard) {
    return static_cast<std::int16_t>(heard[1] + 256 * heard[2]);
  };
  wait_for([&] {
    open->device->write(push);
    const Bytes last = board.written().back();
    return last.size() == 15 && current(last) == -1033;
  });
  // Nobody renews it.
  wait_for([&] { return current(board.written().back()) == 0; });
  plugged = false;
  board.unplug();
  wait_for([&] { return !open->device->read().connected; });
  answered = board.times_written();
  asks = true;
  board.plug();
  plugged = true;
  wait_for([&] { return open->device->read().connected; });
  open->device.reset();
  EXPECT_EQ(current(board.written().back()), 0);
  on = false;
  firmware.join();
}

}  // namespace
}  // namespace fulcrum::test
