#include "engine/app/window/frame_rate.h"

#include <gtest/gtest.h>

namespace fulcrum::app {
namespace {

TEST(FrameRate, TellsThatOfLateAndThatOfAll) {
  FrameRate rate;
  EXPECT_EQ(rate.of_late(), 0);
  EXPECT_EQ(rate.mean(), 0);
  for (int i = 0; i <= 32; ++i) rate.note(100 + i * 0.0625);  // 16 a second, for 2 s
  EXPECT_DOUBLE_EQ(rate.of_late(), 16);
  EXPECT_DOUBLE_EQ(rate.mean(), 16);
  for (int i = 1; i <= 8; ++i) rate.note(102 + i * 0.125);  // 8 a second, for 1 s
  EXPECT_DOUBLE_EQ(rate.of_late(), 8);
  EXPECT_DOUBLE_EQ(rate.mean(), 40 / 3.0);
}

TEST(FrameRate, IsOfTheTimeInWhichSomethingIsDrawn) {
  FrameRate rate;
  for (int i = 0; i <= 16; ++i) rate.note(i * 0.0625);
  rate.rest();
  rate.rest();
  for (int i = 0; i <= 16; ++i) rate.note(60 + i * 0.0625);
  EXPECT_DOUBLE_EQ(rate.mean(), 16);
  EXPECT_DOUBLE_EQ(rate.of_late(), 16);
}

TEST(FrameRate, OfOneFrameIsUnknown) {
  FrameRate rate;
  rate.note(5);
  EXPECT_EQ(rate.of_late(), 0);
  EXPECT_EQ(rate.mean(), 0);
}

}  // namespace
}  // namespace fulcrum::app
