// Every device that --device takes is listed, and one that is not there says why.

#include "drivers/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace fulcrum::test {
namespace {

TEST(Registry, NamesEachDeviceOnceAndSaysWhatItIs) {
  std::set<std::string> names;
  for (const DeviceListing& device : list_devices("")) {
    EXPECT_TRUE(names.insert(device.name).second) << device.name;
    EXPECT_FALSE(device.what.empty()) << device.name;
    EXPECT_EQ(device.present, device.reason.empty()) << device.name;
  }
  for (const char* name : {"simulated", "mouse"}) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Registry, WithoutAWindowThereIsNoMouse) {
  const std::vector<DeviceListing> devices = list_devices("there is no display");
  const auto mouse = std::ranges::find(devices, "mouse", &DeviceListing::name);
  ASSERT_NE(mouse, devices.end());
  EXPECT_FALSE(mouse->present);
  EXPECT_NE(mouse->reason.find("there is no display"), std::string::npos) << mouse->reason;
  const auto simulated = std::ranges::find(devices, "simulated", &DeviceListing::name);
  ASSERT_NE(simulated, devices.end());
  EXPECT_TRUE(simulated->present);
}

TEST(Registry, ANameIsOneDeviceOrOneThatVibratesBesideAnother) {
  const auto one = read_device_name("spacemouse");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->moves, "spacemouse");
  EXPECT_EQ(one->beside, "");
  const auto two = read_device_name("mouse+dualsense");
  ASSERT_TRUE(two);
  EXPECT_EQ(two->moves, "mouse");
  EXPECT_EQ(two->beside, "dualsense");
  const auto held = read_device_name("polhem+strip");
  ASSERT_TRUE(held);
  EXPECT_EQ(held->moves, "polhem");
  EXPECT_EQ(held->beside, "strip");
  const auto file = read_device_name("replay:a+b.tape");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->moves, "replay:a+b.tape") << "a file may be called so";
  const auto card = read_device_name("mouse+audio:hw:1,0");
  ASSERT_TRUE(card);
  EXPECT_EQ(card->moves, "mouse");
  EXPECT_EQ(card->beside, "audio:hw:1,0");
  EXPECT_EQ(table_of(card->beside), "audio");
  for (const char* name : {"simulated+dualsense", "simulated:w6d+audio", "dualsense+dualsense_coils"})
    EXPECT_TRUE(read_device_name(name)) << name;
  for (const char* name : {"", "+", "spacemaus", "spacemouse+", "spacemouse+mouse", "audio", "audio:hw:1,0",
                           "audio+mouse", "mouse+audio+audio", "dualsense_coils", "dualsense+dualsense",
                           "mouse+dualsense+dualshock4", "mouse:left", "replay", "strip", "strip+dualsense",
                           "strip+strip", "simulated+strip", "polhem+strip+strip"}) {
    const auto refused = read_device_name(name);
    ASSERT_FALSE(refused) << name;
    EXPECT_GT(refused.error().sentence.size(), 40U) << refused.error().sentence;
  }
}

TEST(Registry, WhatMovesAsItIsSeenIsHeldInAHand) {
  for (const char* name :
       {"mouse", "spacemouse", "keyboard", "spacemouse+dualsense", "joycon", "switch_pro", "mouse+strip"})
    EXPECT_TRUE(moves_as_seen(name)) << name;
  for (const char* name : {"simulated", "replay:run.tape", "scenario:arm", "nothing", "polhem"})
    EXPECT_FALSE(moves_as_seen(name)) << name;
  for (const char* name : {"polhem", "polhem+dualsense", "polhem+strip", "falcon"})
    EXPECT_TRUE(pushes_back(name)) << name;
  for (const char* name : {"simulated", "mouse", "dualsense", "nothing"})
    EXPECT_FALSE(pushes_back(name)) << name;
}

TEST(Registry, AStripSensesBesideWhatMovesAndIsNothingAlone) {
  for (const char* name : {"polhem+strip", "mouse+strip", "dualsense+strip"})
    EXPECT_TRUE(senses_beside(name)) << name;
  for (const char* name : {"strip", "polhem", "spacemouse+dualsense", "replay:a+strip", "mouse+"})
    EXPECT_FALSE(senses_beside(name)) << name;
  EXPECT_NE(read_device_name("strip").error().sentence.find("polhem+strip"), std::string::npos);
  EXPECT_FALSE(moves_as_seen("strip"));
  EXPECT_NE(best_device("").name, "strip");
}

TEST(Registry, TheMouseIsTakenWhereNothingElseIsThere) {
  const DeviceListing best = best_device("");
  EXPECT_TRUE(best.present);
  for (const DeviceListing& device : list_devices("")) {
    if (device.name == best.name) break;
    const bool held = moves_as_seen(device.name);
    EXPECT_FALSE(held && device.present) << device.name << " comes before " << best.name;
  }
}

TEST(Registry, WhatPlaysOnACardIsKnownByItsName) {
  for (const char* name : {"mouse+audio", "polhem+audio:hw:1,0", "simulated:w6d+dualsense_coils"})
    EXPECT_TRUE(plays_sound(name)) << name;
  for (const char* name : {"mouse", "audio", "mouse+dualsense", "replay:a+audio", "nothing"})
    EXPECT_FALSE(plays_sound(name)) << name;
  for (const char* name : {"simulated", "simulated:w6d", "simulated+audio"})
    EXPECT_TRUE(is_simulated(name)) << name;
  for (const char* name : {"mouse+audio", "replay:run.tape"}) EXPECT_FALSE(is_simulated(name)) << name;
}

// Nothing asks for a card where nothing drives the channels, whatever it is called.
TEST(Registry, WhereNothingVibratesNoCardIsOpened) {
  const auto opened =
      open_device("mouse+audio:no such PCM", {.desc = MouseDevice::mouse_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(opened) << opened.error().sentence;
  EXPECT_EQ(opened->sound, nullptr);
  EXPECT_NE(opened->mouse, nullptr);
}

// A hand cannot keep up with ticks that come as fast as they can.
TEST(Registry, WhatAHandHoldsNeedsAWindowOrAClock) {
  for (const char* name : {"mouse", "keyboard"}) {
    const auto refused = refuse_device(name, {"There is no display.", true});
    ASSERT_TRUE(refused) << name;
    EXPECT_NE(refused->sentence.find("There is no display."), std::string::npos) << refused->sentence;
    EXPECT_FALSE(refuse_device(name, {})) << name;
  }
  EXPECT_FALSE(refuse_device("simulated", {"There is no display."}));
  EXPECT_FALSE(refuse_device("replay:run.tape", {"There is no display."}));
}

TEST(Registry, KeysMoveADeviceThatTheWindowTalksTo) {
  const auto opened = open_device("keyboard", {.desc = MouseDevice::mouse_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(opened);
  ASSERT_NE(opened->rate, nullptr);
  ASSERT_NE(opened->keys, nullptr);
  opened->keys->push({.way = {0, 1, 0}});
  for (int tick = 0; tick < 100; ++tick) opened->device->read();
  EXPECT_GT(opened->device->read().X_DH.p.y(), 0);
  opened->rate->look({.rests = true});
  for (int tick = 0; tick < 1000; ++tick) opened->device->read();
  const double rests = opened->device->read().X_DH.p.y();
  for (int tick = 0; tick < 100; ++tick) opened->device->read();
  EXPECT_NEAR(opened->device->read().X_DH.p.y(), rests, 1e-12);
}

// Where no maker's library is installed, as here, that is said with its remedy.
TEST(Registry, AMakersLibraryThatIsMissingIsSaid) {
  for (const DeviceListing& device : list_devices("")) {
    if (device.name != "omega6" && device.name != "touch") continue;
    EXPECT_FALSE(device.present);
    EXPECT_NE(device.reason.find("library of its maker is not there"), std::string::npos) << device.reason;
    EXPECT_NE(device.reason.find("LD_LIBRARY_PATH"), std::string::npos) << device.reason;
  }
}

TEST(Registry, TheRulesNameEachDeviceByEitherBus) {
  const std::string rules = udev_rules();
  for (const char* part :
       {"ATTRS{idVendor}==\"256f\", ATTRS{idProduct}==\"c635\"", "KERNELS==\"0005:054C:0CE6.*\"",
        "ATTRS{idVendor}==\"054c\", ATTRS{idProduct}==\"09cc\"", "KERNELS==\"0005:057E:2006.*\"",
        "KERNELS==\"0005:057E:2007.*\"", "ATTRS{idVendor}==\"057e\", ATTRS{idProduct}==\"2009\"",
        "ATTRS{idVendor}==\"1209\", ATTRS{idProduct}==\"0001\"", "TAG+=\"uaccess\"",
        "SUBSYSTEM==\"usb\", ENV{DEVTYPE}==\"usb_device\", ATTR{idVendor}==\"0403\", "
        "ATTR{idProduct}==\"cb48\""})
    EXPECT_NE(rules.find(part), std::string::npos) << part;
  EXPECT_EQ(rules.find("cb48"), rules.rfind("cb48")) << "no rule of hidraw for what speaks no HID";
  EXPECT_TRUE(knows_usb(0x0403, 0xcb48));
  EXPECT_TRUE(knows_usb(0x256f, 0xc635));
  EXPECT_FALSE(knows_usb(0x0403, 0x6001)) << "any other FTDI";
}

TEST(Registry, OfServicesThereIsTheInverse3s) {
  const std::vector<DeviceListing> services = list_services("no window");
  ASSERT_EQ(services.size(), 1u);
  EXPECT_EQ(services[0].name, "inverse3");
}

}  // namespace
}  // namespace fulcrum::test
