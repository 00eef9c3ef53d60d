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

}  // namespace
}  // namespace fulcrum::test
