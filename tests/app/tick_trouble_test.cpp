#include "engine/app/window/tick_trouble.h"

#include <gtest/gtest.h>

namespace fulcrum::app {
namespace {

TEST(TickTrouble, IsThereWhileTicksAreLostAndGoneAWindowLater) {
  TickTrouble trouble(1e-3);
  trouble.note(1999, 0, 3);
  EXPECT_FALSE(trouble.is_there());  // the window is not over
  trouble.note(2000, 0, 3);
  EXPECT_TRUE(trouble.is_there());
  trouble.note(3999, 0, 3);
  EXPECT_TRUE(trouble.is_there());
  trouble.note(4000, 0, 3);
  EXPECT_FALSE(trouble.is_there());
}

TEST(TickTrouble, AFewLateTicksAreNone) {
  TickTrouble trouble(1e-3);
  trouble.note(2000, 199, 0);
  EXPECT_FALSE(trouble.is_there());
  trouble.note(4000, 399, 0);
  EXPECT_TRUE(trouble.is_there());
}

TEST(TickTrouble, OfNothingThereIsNone) {
  TickTrouble trouble;
  trouble.note(0, 0, 0);
  trouble.note(0, 0, 0);
  EXPECT_FALSE(trouble.is_there());
}

}  // namespace
}  // namespace fulcrum::app
