// Which gamepads are found in what Linux shows, and where their controls are said to be.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "drivers/gamepad/find_gamepads.h"
#include "drivers/registry.h"
#include "tests/drivers_mock/mock_devices.h"

namespace fulcrum::test {
namespace {

// As Linux 6.1 shows an Xbox 360 pad: A, B, X, Y, two bumpers, back, start, guide, two sticks; axes X, Y, Z,
// RX, RY, RZ and a cross.
constexpr const char* kXboxKeys = "7cdb000000000000 0 0 0 0";
constexpr const char* kXboxAxes = "3003f";

std::string input_device(int number, const std::string& name, const char* vendor, const char* product,
                         const char* keys, const char* axes) {
  const std::string n = std::to_string(number);
  const std::string path = "/devices/virtual/input/input" + n;
  return "P: " + path + "\nE: SUBSYSTEM=input\nA: name=" + name +
         "\nA: id/bustype=0003\nA: id/vendor=" + vendor + "\nA: id/product=" + product +
         "\nA: id/version=0114\nA: capabilities/key=" + keys + "\nA: capabilities/abs=" + axes +
         "\n\nP: " + path + "/event" + n + "\nN: input/event" + n + "\nE: DEVNAME=/dev/input/event" + n +
         "\nE: SUBSYSTEM=input\nL: device=../../input" + n +
         "\nE: MAJOR=13\nE: MINOR=" + std::to_string(64 + number) + "\n\n";
}

bool is_there(const char* name) {
  const std::vector<DeviceListing> devices = list_devices("");
  return std::ranges::find(devices, name, &DeviceListing::name)->present;
}

TEST_F(Mock, AnXboxPadIsAGamepadAndAMouseIsNone) {
  EXPECT_FALSE(is_there("gamepad"));
  EXPECT_NE(why_no_gamepad().find("none is plugged in"), std::string::npos);
  machine.add(input_device(2, "Optical Mouse", "046d", "c077", "1f0000 0 0 0 0", "0"));
  EXPECT_TRUE(find_gamepads().empty());
  machine.add(input_device(9, "Microsoft X-Box 360 pad", "045e", "028e", kXboxKeys, kXboxAxes));
  const std::vector<GamepadPlace> pads = find_gamepads();
  ASSERT_EQ(pads.size(), 1U);
  EXPECT_EQ(pads[0].node, "/dev/input/event9");
  EXPECT_EQ(pads[0].name, "Microsoft X-Box 360 pad");
  EXPECT_TRUE(pads[0].permitted);
  EXPECT_TRUE(is_there("gamepad"));
  EXPECT_EQ(best_device("").name, "gamepad");
}

// What GLFW and SDL have of this pad in their own list.
TEST_F(Mock, ItsControlsAreWhereTheListsOfGamesHaveThem) {
  machine.add(input_device(3, "Microsoft X-Box 360 pad", "045e", "028e", kXboxKeys, kXboxAxes));
  const std::vector<GamepadPlace> pads = find_gamepads();
  ASSERT_EQ(pads.size(), 1U);
  EXPECT_TRUE(pads[0].mapping.starts_with("030000005e0400008e02000014010000,")) << pads[0].mapping;
  for (const char* part : {",a:b0,",
                           ",b:b1,",
                           ",x:b2,",
                           ",y:b3,",
                           ",leftshoulder:b4,",
                           ",rightshoulder:b5,",
                           ",back:b6,",
                           ",start:b7,",
                           ",guide:b8,",
                           ",leftstick:b9,",
                           ",rightstick:b10,",
                           ",leftx:a0,",
                           ",lefty:a1,",
                           ",lefttrigger:a2,",
                           ",rightx:a3,",
                           ",righty:a4,",
                           ",righttrigger:a5,",
                           ",dpup:h0.1,",
                           ",dpleft:h0.8,",
                           ",platform:Linux,"})
    EXPECT_NE(pads[0].mapping.find(part), std::string::npos) << part << " in " << pads[0].mapping;
}

TEST_F(Mock, APadWithADriverOfItsOwnIsNoGamepad) {
  machine.add(input_device(4, "Sony DualSense", "054c", "0ce6", kXboxKeys, kXboxAxes));
  EXPECT_TRUE(find_gamepads().empty());
}

}  // namespace
}  // namespace fulcrum::test
