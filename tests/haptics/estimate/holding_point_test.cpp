#include "haptics/estimate/holding_point.h"
#include "tests/haptics/tick_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fulcrum::test {
namespace {

HoldingStripDesc a_strip() {
  return {};  // 30 to 170 mm, 100 ohm to 10 kohm
}

double ohm_at(double place) {
  return 100 + (place - 0.03) / 0.14 * 9900;
}

HoldingPointDesc default_at(double place) {
  HoldingPointDesc desc;
  desc.place = place;
  return desc;
}

void read_for(HoldingPoint& point, double ohm, double seconds) {
  const int ticks = static_cast<int>(std::lround(seconds / kTick));
  for (int i = 0; i < ticks; ++i) point.update(ohm);
}

TEST(HoldingPoint, AReadingIsTrustedOnceItHasKeptStill) {
  HoldingPoint point(default_at(0.05), a_strip(), kTick);
  EXPECT_EQ(point.state(), HoldingState::lost);
  read_for(point, ohm_at(0.10), 0.020);
  EXPECT_EQ(point.state(), HoldingState::lost);
  EXPECT_EQ(point.place(), 0.05);
  read_for(point, ohm_at(0.10), 0.5);
  EXPECT_EQ(point.state(), HoldingState::measured);
  EXPECT_NEAR(point.place(), 0.10, 1e-9);
  EXPECT_NEAR((point.p_HG() - Vec3(0.10, 0, 0)).norm(), 0, 1e-9);
}

TEST(HoldingPoint, WhatIsLostIsKeptThenFadesToWhatWasTold) {
  for (double lost : {kStripOpen, kNoStrip, 0.0, -50.0, 20e3, -std::numeric_limits<double>::infinity()}) {
    HoldingPoint point(default_at(0.05), a_strip(), kTick);
    read_for(point, ohm_at(0.12), 1);
    read_for(point, lost, 0.49);
    EXPECT_EQ(point.state(), HoldingState::kept);
    EXPECT_NEAR(point.place(), 0.12, 1e-9);
    read_for(point, lost, 0.51);
    EXPECT_EQ(point.state(), HoldingState::fading);
    EXPECT_NEAR(point.place(), 0.085, 1e-4) << "half way";
    read_for(point, lost, 0.55);
    EXPECT_EQ(point.state(), HoldingState::lost);
    EXPECT_NEAR(point.place(), 0.05, 1e-12);
  }
}

TEST(HoldingPoint, NeverFasterThanItsSpeed) {
  HoldingPoint point(default_at(0.03), a_strip(), kTick);
  double last = point.place(), fastest = 0;
  for (int i = 0; i < 20'000; ++i) {
    if (i % 700 == 0) point.tell(i % 1400 == 0 ? 10 : -10);
    if (i % 1500 == 0) point.measure(i % 3000 != 0);
    const double ohm = i % 900 < 500 ? ohm_at(i % 1800 < 900 ? 0.03 : 0.17) : kStripOpen;
    point.update(ohm);
    fastest = std::max(fastest, std::abs(point.place() - last) / kTick);
    last = point.place();
  }
  EXPECT_LE(fastest, 0.2 + 1e-9);
  EXPECT_GT(fastest, 0.2 - 1e-9) << "it was asked to be faster";
}

TEST(HoldingPoint, AHandThatSlidesIsFollowed) {
  HoldingPoint point(default_at(0.05), a_strip(), kTick);
  read_for(point, ohm_at(0.05), 0.5);
  double place = 0.05;
  for (; place < 0.15; place += 0.1 * kTick) {
    point.update(ohm_at(place));
    EXPECT_EQ(point.state(), HoldingState::measured);
    EXPECT_NEAR(point.place(), place, 0.1 * 0.011 + 1e-4) << "it lags by its smoothing";
  }
}

TEST(HoldingPoint, AJumpIsNotBelievedAtOnce) {
  HoldingPoint point(default_at(0.05), a_strip(), kTick);
  read_for(point, ohm_at(0.10), 1);
  point.update(ohm_at(0.16));  // one bad reading
  EXPECT_EQ(point.state(), HoldingState::kept);
  EXPECT_NEAR(point.place(), 0.10, 1e-9);
  read_for(point, ohm_at(0.10), 0.03);
  EXPECT_EQ(point.state(), HoldingState::measured);
  read_for(point, ohm_at(0.16), 1);  // the hand went there
  EXPECT_NEAR(point.place(), 0.16, 1e-9);
}

TEST(HoldingPoint, ToldWinsWhileNothingIsMeasured) {
  HoldingPoint point(default_at(0.05), a_strip(), kTick);
  point.measure(false);
  point.tell(0.11);
  read_for(point, ohm_at(0.16), 1);
  EXPECT_EQ(point.state(), HoldingState::set);
  EXPECT_EQ(point.place(), 0.11);
  point.tell(std::numeric_limits<double>::quiet_NaN());
  read_for(point, ohm_at(0.16), 0.1);
  EXPECT_EQ(point.place(), 0.11);
  point.measure(true);
  read_for(point, ohm_at(0.16), 1);
  EXPECT_EQ(point.state(), HoldingState::measured);
  EXPECT_NEAR(point.place(), 0.16, 1e-9);
}

TEST(HoldingPoint, WithoutAStripItIsLostAtWhatWasTold) {
  HoldingPoint point(default_at(0.05), std::nullopt, kTick);
  read_for(point, kNoStrip, 1);
  read_for(point, ohm_at(0.1), 1);
  EXPECT_EQ(point.state(), HoldingState::lost);
  EXPECT_EQ(point.place(), 0.05);
}

TEST(HoldingPoint, NoTimeToKeepOrFadeIsAtOnce) {
  HoldingPointDesc desc = default_at(0.05);
  desc.keep = desc.fade = desc.settle = desc.smoothing = 0;
  HoldingPoint point(desc, a_strip(), kTick);
  read_for(point, ohm_at(0.10), 1);
  EXPECT_EQ(point.state(), HoldingState::measured);
  point.update(kStripOpen);
  EXPECT_EQ(point.state(), HoldingState::lost);
  read_for(point, kStripOpen, 1);
  EXPECT_EQ(point.place(), 0.05);
}

}  // namespace
}  // namespace fulcrum::test
