// A SpaceMouse by the real hidapi, alone and with a pad beside it.

#include <gtest/gtest.h>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/registry.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "tests/drivers_mock/mock_devices.h"

namespace fulcrum::test {
namespace {

TEST_F(Mock, AxesComeAsSent) {
  MockHid mouse(machine, spacemouse());
  const auto link = linked(spacemouse_ids());
  ASSERT_NE(link, nullptr);
  say_until(
      mouse, kRight, [&] { return link->read().axes.way == Vec3(1, 0, 0); });
  say_until(
      mouse, kBackAndDown, [&] { return link->read().axes.way == Vec3(0, -1, 0.5); });
  say_until(mouse, kTurned, [&] { return link->read().axes.turn == Vec3(1, 1, 0); });
  mouse.say({3, 2, 0});
  wait_for([&] { return link->read().axes.buttons == 2; });
  EXPECT_TRUE(link->read().connected);
  EXPECT_EQ(link->refused(), 0U);
}

// It comes back under another number, as Linux does it while the old one is still open.
TEST_F(Mock, UnpluggedItSaysSoAndPluggedInAgainItGoesOn) {
  MockHid mouse(machine, spacemouse());
  const auto link = linked(spacemouse_ids());
  ASSERT_NE(link, nullptr);
  for (int time = 0; time < 3; ++time) {
    say_until(mouse, kRight, [&] { return link->read().axes.way.x() == 1; });
    mouse.unplug();
    wait_for([&] { return !link->read().connected; });
    EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
    mouse.plug();
    wait_for([&] { return link->read().connected; });
    EXPECT_TRUE(link->read().axes.rests()) << "what was pushed before is not pushed now";
  }
  say_until(mouse, kTurned, [&] { return link->read().axes.turn == Vec3(1, 1, 0); });
}

TEST_F(Mock, SpaceMouseMovesAndDualSenseVibratesBeside) {
  MockHid mouse(machine, spacemouse()), pad(machine, dualsense(false, 0x0224));
  DeviceDesc desc = MouseDevice::mouse_desc();
  desc.vibrotactile = {{{.name = "left", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.04},
                        {.name = "right", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.02}}};
  const DeviceOrder order{.desc = desc, .signal = VibrotactileSignal{.largest = 20}, .X_DH = Pose{}};
  const auto open = open_device("spacemouse+dualsense", order);
  ASSERT_TRUE(open) << open.error().sentence;
  ASSERT_NE(open->rate, nullptr);
  EXPECT_EQ(open->device->read().X_DH.p, Vec3::Zero());
  say_until(mouse, kRight, [&] { return open->device->read().X_DH.p.x() > 1e-3; });
  EXPECT_EQ(open->device->read().X_DH.p.y(), 0);
  DeviceCommand command;
  command.vibrotactile.level = {20, 10};
  wait_for([&] {
    open->device->write(command);
    return !pad.written().empty();
  });
  EXPECT_EQ(pad.written().front()[4], 255) << "left";
  EXPECT_EQ(pad.written().front()[3], 128) << "right";
  EXPECT_TRUE(open->device->read().connected);
  pad.unplug();
  wait_for([&] { return !open->device->read().connected; });
}

// Two of them: the one that was there all along is listed first when the other comes back, and is not taken.
TEST_F(Mock, PluggedInAgainACapIsTheRunsOwn) {
  for (const bool numbered : {true, false}) {
    MockHidFacts facts = spacemouse(), others = spacemouse();
    facts.serial = numbered ? "CAP1" : "";
    others.serial = numbered ? "CAP2" : "";
    facts.wanders = numbered;
    MockHid own(machine, facts), beside(machine, others);
    auto opened = open_device("spacemouse", {.desc = DeviceDesc{}, .X_DH = Pose{}});
    ASSERT_TRUE(opened) << opened.error().sentence;
    own.unplug();
    wait_for([&] { return !opened->device->read().connected; });
    own.plug();
    wait_for([&] { return opened->device->read().connected; });
    own.say(kMiddle);
    beside.say(kMiddle);
    wait_for([&] { return own.all_read() || beside.all_read(); });
    EXPECT_TRUE(own.all_read()) << numbered;
    EXPECT_FALSE(beside.all_read()) << numbered;
  }
}

}  // namespace
}  // namespace fulcrum::test
