// A press counts once, and one that repeats again and again while it is held.

#include "engine/input/pad_presses.h"

#include <gtest/gtest.h>

namespace fulcrum::input::test {
namespace {

constexpr std::uint32_t kA = 1, kLeft = 2;

TEST(PadPresses, WhatIsDownAtFirstWasMeantForWhatWasBefore) {
  PadPresses pad(kLeft);
  EXPECT_EQ(pad.pressed(kA | kLeft, 0), 0U);
  EXPECT_EQ(pad.pressed(0, 0.1), 0U);
  EXPECT_EQ(pad.pressed(kA, 0.2), kA);
  EXPECT_EQ(pad.pressed(kA, 10), 0U) << "A does not repeat";
}

TEST(PadPresses, TheCrossRepeatsAfterAMoment) {
  PadPresses pad(kLeft);
  pad.pressed(0, 0);
  EXPECT_EQ(pad.pressed(kLeft, 1), kLeft);
  for (int look = 1; look < 10; ++look)
    EXPECT_EQ(pad.pressed(kLeft, 1 + 0.09 * look * PadPresses::kFirst), 0U) << look;
  const double first = 1 + 1.01 * PadPresses::kFirst;
  EXPECT_EQ(pad.pressed(kLeft, first), kLeft);
  EXPECT_EQ(pad.pressed(kLeft, first + 0.9 * PadPresses::kNext), 0U);
  EXPECT_EQ(pad.pressed(kLeft, first + 1.1 * PadPresses::kNext), kLeft);
  EXPECT_EQ(pad.pressed(0, 3), 0U);
  EXPECT_EQ(pad.pressed(kLeft, 3.01), kLeft);
}

TEST(PadPresses, WhereAPictureTakesLongAShortPressCountsOnce) {
  PadPresses pad(kLeft);
  pad.pressed(0, 0);
  EXPECT_EQ(pad.pressed(kLeft, 1), kLeft);
  for (int look = 1; look < PadPresses::kLooks; ++look) EXPECT_EQ(pad.pressed(kLeft, 1 + look), 0U) << look;
  EXPECT_EQ(pad.pressed(kLeft, 1 + PadPresses::kLooks), kLeft) << "that is no short press";
}

TEST(PadPresses, AnotherButtonMeanwhileDoesNotRepeatTheFirst) {
  PadPresses pad(kLeft);
  pad.pressed(0, 0);
  pad.pressed(kLeft, 1);
  EXPECT_EQ(pad.pressed(kLeft | kA, 1.1), kA);
}

}  // namespace
}  // namespace fulcrum::input::test
