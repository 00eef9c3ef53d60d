// A gamepad's sticks and triggers as axes, and what becomes of a push that nobody renews.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "drivers/gamepad/gamepad_axes.h"
#include "drivers/registry.h"

namespace fulcrum::test {
namespace {

TEST(Gamepad, EachControlPushesItsAxis) {
  EXPECT_EQ(axes_of({.left_x = 1}).way, Vec3(1, 0, 0));
  EXPECT_EQ(axes_of({.left_y = 1}).way, Vec3(0, 1, 0));
  EXPECT_EQ(axes_of({.left_trigger = 1}).way, Vec3(0, 0, 1)) << "toward the person";
  EXPECT_EQ(axes_of({.right_trigger = 1}).way, Vec3(0, 0, -1));
  EXPECT_EQ(axes_of({.right_y = -1}).turn, Vec3(1, 0, 0)) << "pulled down, what is in front comes up";
  EXPECT_EQ(axes_of({.right_x = 1}).turn, Vec3(0, 1, 0));
  EXPECT_EQ(axes_of({.left_bumper = true}).turn, Vec3(0, 0, 1)) << "against the clock";
  EXPECT_EQ(axes_of({.right_bumper = true}).turn, Vec3(0, 0, -1));
  for (const GamepadReading& one : {GamepadReading{.left_x = 1}, GamepadReading{.left_trigger = 1}})
    EXPECT_TRUE(axes_of(one).turn.isZero(0));
}

TEST(Gamepad, ASticksUnrestIsNoPush) {
  EXPECT_TRUE(axes_of({.left_x = 0.09, .left_y = -0.09, .right_x = 0.09, .left_trigger = 0.09}).rests());
  const double beyond = axes_of({.left_x = -0.2}).way.x();
  EXPECT_LT(beyond, 0);
  EXPECT_GT(beyond, -0.2) << "it begins from rest";
}

TEST(Gamepad, WhatNobodyRenewsIsLetGo) {
  GamepadAxes pad;
  EXPECT_TRUE(pad.read().connected) << "before the window's first look";
  pad.push({.way = {1, 0, 0}});
  EXPECT_EQ(pad.read().axes.way.x(), 1);
  std::this_thread::sleep_for(std::chrono::duration<double>(1.2 * GamepadAxes::kKept));
  EXPECT_TRUE(pad.read().axes.rests());
  EXPECT_TRUE(pad.read().connected) << "a window that stands still is no lost device";
  pad.push({.way = {0, 1, 0}});
  EXPECT_EQ(pad.read().axes.way.y(), 1);
}

TEST(Gamepad, OneThatIsGoneIsALostDeviceUntilItIsBack) {
  const auto opened = open_device("gamepad", {.desc = MouseDevice::mouse_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(opened) << opened.error().sentence;
  ASSERT_NE(opened->gamepad, nullptr);
  opened->gamepad->push({.way = {1, 0, 0}});
  EXPECT_TRUE(opened->device->read().connected);
  opened->gamepad->lose();
  EXPECT_FALSE(opened->device->read().connected);
  for (int tick = 0; tick < 1000; ++tick) opened->device->read();
  const double rests = opened->device->read().X_DH.p.x();
  for (int tick = 0; tick < 100; ++tick) opened->device->read();
  EXPECT_NEAR(opened->device->read().X_DH.p.x(), rests, 1e-12) << "the last push does not go on";
  opened->gamepad->push({});
  EXPECT_TRUE(opened->device->read().connected);
}

TEST(Gamepad, IsTakenBeforeTheMouseAndAfterPadsWithADriver) {
  std::vector<std::string> names;
  for (const DeviceListing& device : list_devices("")) names.push_back(device.name);
  const auto place = [&](const char* name) { return std::ranges::find(names, name) - names.begin(); };
  EXPECT_LT(place("dualsense"), place("gamepad"));
  EXPECT_LT(place("gamepad"), place("mouse"));
  EXPECT_TRUE(moves_as_seen("gamepad"));
  EXPECT_TRUE(has_table("gamepad"));
}

}  // namespace
}  // namespace fulcrum::test
