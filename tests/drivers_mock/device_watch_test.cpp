// Devices that come and go, as `fulcrum devices --watch` sees them.

#include "drivers/watch/device_watch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/drivers_mock/mock_hid.h"

namespace fulcrum::test {
namespace {

// Of a device with six axes: a report of a multi-axis controller.
MockHidFacts cap() {
  return {.id = {0x256f, 0xc635},
          .name = "SpaceMouse Compact",
          .descriptor = {0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0x85, 0x01, 0x75, 0x08, 0x95, 0x06, 0x81, 0x02,
                         0xC0}};
}

class WatchMock : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(machine.stands_in()) << "begin it by umockdev-wrapper"; }

  // What two looks tell: the first sees that something has changed, the second that it stays so.
  std::vector<DeviceListing> news(DeviceWatch& watch) const {
    EXPECT_TRUE(watch.look().empty()) << "told before it was known to stay so";
    return watch.look();
  }

  MockMachine machine;
  const DeviceWatch::List list = [this] {
    ++listed;
    return list_devices("no window");
  };
  int listed = 0;
};

TEST_F(WatchMock, TellsWhatComesAndGoesAndWhere) {
  DeviceWatch watch(list);
  MockHid mouse(machine, cap());
  std::vector<DeviceListing> told = news(watch);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].name, "spacemouse");
  EXPECT_TRUE(told[0].present);
  EXPECT_EQ(told[0].node, mouse.node());
  EXPECT_EQ(told[0].permitted, true);
  EXPECT_EQ(told[0].firmware, "1.00");  // as the mocked device's bcdDevice has it
  EXPECT_EQ(told[0].table, "spacemouse");

  mouse.unplug();
  told = news(watch);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].name, "spacemouse");
  EXPECT_FALSE(told[0].present);
  EXPECT_NE(told[0].reason.find("plugged in"), std::string::npos);
  EXPECT_EQ(told[0].node, "");
  EXPECT_EQ(told[0].permitted, std::nullopt);

  mouse.plug();
  told = news(watch);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].node, mouse.node());
}

TEST_F(WatchMock, WhereNothingChangesNoDriverIsAsked) {
  MockHid mouse(machine, cap());
  DeviceWatch watch(list);
  const auto there = std::ranges::find(watch.devices(), "spacemouse", &DeviceListing::name);
  ASSERT_NE(there, watch.devices().end());
  EXPECT_TRUE(there->present);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(watch.look().empty());
  EXPECT_EQ(listed, 1);
}

TEST_F(WatchMock, WhatIsGoneAgainBeforeItWasToldIsNotTold) {
  DeviceWatch watch(list);
  MockHid mouse(machine, cap());
  EXPECT_TRUE(watch.look().empty());
  mouse.unplug();
  EXPECT_TRUE(watch.look().empty());
  EXPECT_TRUE(watch.look().empty());
  EXPECT_EQ(listed, 1) << "a driver was asked for what had gone";
}

// Only a device of ours is told, though the drivers are asked.
TEST_F(WatchMock, OthersAreNotTold) {
  DeviceWatch watch(list);
  MockHidFacts facts = cap();
  facts.id = {0x046d, 0xc534};
  MockHid other(machine, facts);
  EXPECT_TRUE(news(watch).empty());
  EXPECT_EQ(listed, 2);
}

}  // namespace
}  // namespace fulcrum::test
