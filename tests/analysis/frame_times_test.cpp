// Medians of frames whose times are known.

#include "engine/analysis/picture/frame_times.h"

#include <gtest/gtest.h>

namespace fulcrum::analysis::picture {
namespace {

// A card that takes four times as long for its first 0.2 s, two levels by turns.
TEST(FrameTimes, WhatACardTakesAtALowClockDoesNotCount) {
  FrameTimes times(2);
  double drawn_s = 0;
  int rounds = 0;
  for (; !times.are_enough(); ++rounds)
    for (const double frame_s : {0.002, 0.001}) {
      const double slowed_s = (drawn_s < 0.2 ? 4 : 1) * frame_s;
      times.add(slowed_s);
      drawn_s += slowed_s;
    }
  EXPECT_DOUBLE_EQ(times.median_ms(0), 2);
  EXPECT_DOUBLE_EQ(times.median_ms(1), 1);
  EXPECT_GT(drawn_s, 0.75) << "a quarter of a second does not count, and half a second has to";
  EXPECT_LT(drawn_s, 0.80);
}

TEST(FrameTimes, SlowFramesAreCountedToo) {
  FrameTimes times(1);
  int frames = 0;
  for (; !times.are_enough(); ++frames) times.add(frames < 3 ? 5 : frames % 2 == 0 ? 1 : 1.5);
  EXPECT_EQ(frames, 12) << "three that compile shaders, and nine";
  EXPECT_DOUBLE_EQ(times.median_ms(0), 1000 * (1.5));
}

// A machine on which every frame takes a percent longer than the one before, whatever level it is of.
TEST(FrameTimes, OfTurnsCompareLevelsOnAMachineThatBecomesSlower) {
  double slowed = 1;
  const Result<FrameTimes> times = FrameTimes::by_turns(2, [&](std::size_t level) -> Result<double> {
    slowed *= 1.01;
    return slowed * (level == 0 ? 0.02 : 0.01);
  });
  ASSERT_TRUE(times);
  EXPECT_NEAR(times->median_ms(0) / times->median_ms(1), 2, 0.03);
}

TEST(FrameTimes, EndWithTheFirstFrameThatCannotBeDrawn) {
  int drawn = 0;
  const Result<FrameTimes> times = FrameTimes::by_turns(2, [&](std::size_t level) -> Result<double> {
    ++drawn;
    if (level == 1) return Error{"The GPU is lost."};
    return 0.01;
  });
  ASSERT_FALSE(times);
  EXPECT_EQ(times.error().sentence, "The GPU is lost.");
  EXPECT_EQ(drawn, 2);
}

}  // namespace
}  // namespace fulcrum::analysis::picture
