// Reports written by hand from what is known of them: X right, Y toward the person, Z down, 350 at the stop.

#include "drivers/spacemouse/spacemouse_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace fulcrum::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes report(std::uint8_t number, std::initializer_list<int> readings) {
  Bytes bytes{number};
  for (const int reading : readings) {
    const auto word = static_cast<std::uint16_t>(static_cast<std::int16_t>(reading));
    bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(word >> 8));
  }
  return bytes;
}

TEST(SpaceMouse, AxesAreRightUpAndTowardThePerson) {
  SpaceMouseProtocol mouse;
  PushedAxes axes;
  ASSERT_TRUE(mouse.decode(report(1, {350, -70, 175}), axes));
  EXPECT_EQ(axes.way, Vec3(1, -0.5, -0.2));
  EXPECT_TRUE(axes.turn.isZero());
  ASSERT_TRUE(mouse.decode(report(2, {35, 350, -350}), axes));
  EXPECT_EQ(axes.way, Vec3(1, -0.5, -0.2)) << "the other report's axes stay";
  EXPECT_EQ(axes.turn, Vec3(0.1, 1, 1));
}

TEST(SpaceMouse, ALongReportHasAllSixAxes) {
  SpaceMouseProtocol mouse;
  PushedAxes axes;
  ASSERT_TRUE(mouse.decode(report(1, {0, 350, 0, 0, 0, 350}), axes));
  EXPECT_EQ(axes.way, Vec3(0, 0, 1));
  EXPECT_EQ(axes.turn, Vec3(0, -1, 0));
}

TEST(SpaceMouse, PushedBeyondItsStopIsFullyPushed) {
  SpaceMouseProtocol mouse;
  PushedAxes axes;
  ASSERT_TRUE(mouse.decode(report(1, {32767, -32768, 351}), axes));
  EXPECT_EQ(axes.way, Vec3(1, -1, -1));
}

TEST(SpaceMouse, ButtonsAreBits) {
  SpaceMouseProtocol mouse;
  PushedAxes axes;
  ASSERT_TRUE(mouse.decode(Bytes{3, 0x02, 0x80}, axes));
  EXPECT_EQ(axes.buttons, 0x8002U);
  ASSERT_TRUE(mouse.decode(Bytes{3, 0x00, 0x00, 0x00, 0x01}, axes));
  EXPECT_EQ(axes.buttons, 0x01000000U);
}

TEST(SpaceMouse, WhatIsNoneOfItsReportsChangesNothing) {
  SpaceMouseProtocol mouse;
  PushedAxes axes{Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.5, 0.6), 7};
  for (const Bytes& bytes : {Bytes{}, Bytes{1}, Bytes{1, 0, 0, 0, 0, 0}, Bytes{2, 1, 2, 3}, Bytes{3, 1},
                             Bytes{0x17, 90}, Bytes{4, 1}, Bytes(13, 0xFF)}) {
    EXPECT_FALSE(mouse.decode(bytes, axes));
    EXPECT_EQ(axes.way, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(axes.turn, Vec3(0.4, 0.5, 0.6));
    EXPECT_EQ(axes.buttons, 7U);
  }
}

TEST(SpaceMouse, IsKnownByItsNumbersAndNoOtherMouseIs) {
  const auto known = [](hid::HidId id) { return std::ranges::count(spacemouse_ids(), id) == 1; };
  EXPECT_TRUE(known({0x256f, 0xc635}));
  EXPECT_TRUE(known({0x046d, 0xc626}));
  for (const std::uint16_t product : std::initializer_list<std::uint16_t>{0xc650, 0xc651, 0xc654, 0xc658})
    EXPECT_FALSE(known({0x256f, product})) << "a mouse without a cap";
}

}  // namespace
}  // namespace fulcrum::test
