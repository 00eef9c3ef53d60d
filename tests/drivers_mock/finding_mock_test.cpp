// Which emulated devices the real hidapi and libudev find, and what is said of those that may not be opened.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>
#include <thread>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/registry.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "tests/drivers_mock/mock_devices.h"
#include "tests/drivers_mock/privileges.h"

namespace fulcrum::test {
namespace {

constexpr hid::HidId kCadMouse{0x256f, 0xc650};

TEST_F(Mock, WithoutDevicesNoneIsFound) {
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
  for (const DeviceListing& device : list_devices(""))
    if (device.name == "spacemouse" || device.name == "dualsense") EXPECT_FALSE(device.present);
}

TEST_F(Mock, SpaceMouseIsFoundAndCadMouseIsNot) {
  MockHid cadmouse(machine, {.id = kCadMouse, .name = "CadMouse", .descriptor = descriptor(kMouseUsage)});
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
  MockHid mouse(machine, spacemouse());
  const std::vector<hid::HidPlace> places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].id, kSpaceMouse);
  EXPECT_EQ(places[0].path, mouse.node());
  EXPECT_EQ(places[0].product, "SpaceMouse Compact");
  EXPECT_FALSE(places[0].bluetooth);
  EXPECT_TRUE(places[0].permitted);
  EXPECT_TRUE(hid::find_hid(dualsense::usb_ids()).empty());
}

// Some devices have a second node, which types.
TEST_F(Mock, ANodeThatReportsNoAxesIsPassedOver) {
  MockHidFacts keys = spacemouse();
  keys.descriptor = descriptor(kKeyboardUsage);
  MockHid keyboard(machine, keys);
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
  MockHid mouse(machine, spacemouse());
  const std::vector<hid::HidPlace> places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].path, mouse.node());
}

TEST_F(Mock, TheBusIsKnown) {
  MockHid by_usb(machine, dualsense(false, 0)), by_bluetooth(machine, dualsense(true, 0));
  const std::vector<hid::HidPlace> places = hid::find_hid(dualsense::usb_ids());
  ASSERT_EQ(places.size(), 2U);
  for (const hid::HidPlace& place : places) {
    EXPECT_EQ(place.bluetooth, place.path == by_bluetooth.node()) << place.path;
    EXPECT_EQ(place.product, "Wireless Controller") << place.path;
  }
}

TEST_F(Mock, ReportsAreReadOneByOne) {
  MockHid mouse(machine, spacemouse());
  const auto places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  const auto port = hid::open_hid(places[0]);
  ASSERT_TRUE(port) << port.error().sentence;
  std::array<std::uint8_t, 64> bytes{};
  EXPECT_EQ((*port)->read(bytes, 0), 0) << "it has said nothing";
  const std::vector<Bytes> all{kRight, kTurned, {3, 1, 0}, kMiddle};
  for (const Bytes& report : all) mouse.say(report);
  for (const Bytes& report : all) {
    const int length = (*port)->read(bytes, -1);
    ASSERT_EQ(length, static_cast<int>(report.size()));
    EXPECT_TRUE(std::equal(report.begin(), report.end(), bytes.begin()));
  }
  EXPECT_EQ((*port)->read(bytes, 0), 0);
}

// Of a device that is being unplugged.
TEST_F(Mock, ANodeWithoutANameIsPassedOver) {
  MockHidFacts facts = spacemouse();
  facts.named = false;
  MockHid going(machine, facts);
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
}

TEST_F(Mock, ADeviceThatGoesWhileItIsOpenedIsNotOpened) {
  MockHid mouse(machine, spacemouse());
  const auto places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  mouse.go();
  EXPECT_FALSE(hid::open_hid(places[0]));
  mouse.unplug();
  EXPECT_FALSE(hid::open_hid(places[0]));
}

TEST_F(Mock, ANodeThatMayNotBeOpenedSaysWhatWouldCureIt) {
  MockHid mouse(machine, spacemouse());
  ASSERT_EQ(chmod(mouse.node().c_str(), 0), 0);
  bool forbidden = false;
  std::vector<hid::HidPlace> places;
  std::vector<DeviceListing> listings;
  std::string refusal;
  std::thread([&] {
    forbidden = open_by_modes_alone() && access(mouse.node().c_str(), R_OK) != 0;
    if (!forbidden) return;
    places = hid::find_hid(spacemouse_ids());
    listings = list_devices("");
    const auto port = hid::open_hid(places.at(0));
    if (!port) refusal = port.error().sentence;
  }).join();
  if (!forbidden) GTEST_SKIP() << "this system lets whoever runs the tests open a node of mode 0";
  ASSERT_EQ(places.size(), 1U) << "it is seen, though it may not be opened";
  EXPECT_FALSE(places[0].permitted);
  const auto listed = std::ranges::find(listings, "spacemouse", &DeviceListing::name);
  ASSERT_NE(listed, listings.end());
  EXPECT_FALSE(listed->present);
  for (const std::string& sentence : {listed->reason, refusal})
    for (const std::string& part : {mouse.node(), std::string("tools/run --udev")})
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

TEST_F(Mock, WhatIsPluggedInIsListedAsThere) {
  MockHid mouse(machine, spacemouse()), pad(machine, dualsense(true, 0));
  for (const DeviceListing& device : list_devices("no window"))
    if (device.name == "spacemouse" || device.name == "dualsense")
      EXPECT_TRUE(device.present) << device.reason;
  EXPECT_EQ(best_device("").name, "spacemouse");
}

}  // namespace
}  // namespace fulcrum::test
