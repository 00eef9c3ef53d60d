// What hands ask for: only a squeeze that somebody saw begin goes on after a stop.

#include "engine/headset/tool_in_hands.h"

#include <gtest/gtest.h>

namespace fulcrum::headset {
namespace {

using Asked = std::optional<Command::Kind>;

class AskedByHands : public testing::Test {
protected:
  // The right one; the left one is never there.
  Asked right(xr::Hand hand, bool seen = true) {
    hand.X_LG = Pose{};
    const std::optional<Command> command = tool_.follow({xr::Hand{}, hand}, {}, seen, true);
    return command ? Asked(command->kind) : std::nullopt;
  }

  static xr::Hand told(bool holds, bool stops) {
    xr::Hand hand;
    hand.is_known = true;
    hand.holds = holds;
    hand.stops = stops;
    return hand;
  }
  static xr::Hand open() { return told(false, false); }
  static xr::Hand squeezes() { return told(true, false); }
  static xr::Hand stops() { return told(false, true); }
  static xr::Hand sleeps() { return {}; }

  ToolInHands tool_{Pose{}};
};

TEST_F(AskedByHands, ASqueezeGoesOnAndAStopStops) {
  EXPECT_EQ(right(open()), std::nullopt);
  EXPECT_EQ(right(squeezes()), Command::Kind::acknowledge);
  EXPECT_EQ(right(squeezes()), std::nullopt);
  EXPECT_EQ(right(stops()), Command::Kind::stop);
  EXPECT_EQ(right(squeezes()), Command::Kind::acknowledge);
}

TEST_F(AskedByHands, ASqueezeThatNobodyTellsOfForAWhileHasToEndFirst) {
  right(open());
  right(squeezes());
  for (int i = 0; i < 5; ++i) EXPECT_EQ(right(sleeps()), std::nullopt);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(right(squeezes()), std::nullopt);
  EXPECT_EQ(right(open()), std::nullopt);
  EXPECT_EQ(right(squeezes()), Command::Kind::acknowledge);
}

TEST_F(AskedByHands, ASqueezeThatBeganUntoldHasToEndFirst) {
  EXPECT_EQ(right(squeezes()), Command::Kind::acknowledge) << "told from the first picture on";
  right(open());
  EXPECT_EQ(right(sleeps()), std::nullopt);
  EXPECT_EQ(right(squeezes()), std::nullopt);
  EXPECT_EQ(right(open()), std::nullopt);
  EXPECT_EQ(right(squeezes()), Command::Kind::acknowledge);
}

TEST_F(AskedByHands, ASqueezeThatNobodySawHasToEndFirst) {
  right(open());
  EXPECT_EQ(right(squeezes(), false), std::nullopt);
  EXPECT_EQ(right(squeezes()), std::nullopt);
  EXPECT_EQ(right(open(), false), std::nullopt);
  EXPECT_EQ(right(squeezes()), std::nullopt) << "it began between two pictures, of which one was not seen";
  right(open());
  EXPECT_EQ(right(squeezes()), Command::Kind::acknowledge);
}

TEST_F(AskedByHands, AStopIsHeardFromWhoIsNotSeenAndAsSoonAsItIsTold) {
  EXPECT_EQ(right(stops(), false), Command::Kind::stop);
  right(sleeps());
  EXPECT_EQ(right(stops()), Command::Kind::stop);
}

}  // namespace
}  // namespace fulcrum::headset
