#include "haptics/device/holding_strip.h"
#include "tests/haptics/tick_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fulcrum::test {
namespace {

HoldingStripDesc exact() {
  HoldingStripDesc desc;
  desc.noise_ohm = 0;
  return desc;
}

TEST(HoldingStrip, IsLinearAlongItsLength) {
  SimulatedStrip strip(exact(), kTick, 1);
  EXPECT_NEAR(strip.advance(0.03, 2), 100, 1e-9);
  EXPECT_NEAR(strip.advance(0.17, 2), 10000, 1e-9);
  EXPECT_NEAR(strip.advance(0.10, 2), 5050, 1e-9);
  for (double place : {0.03, 0.05, 0.11, 0.17})
    EXPECT_NEAR(place_of(exact(), strip.advance(place, 2)), place, 1e-12);
}

TEST(HoldingStrip, ClosesAboveAndOpensBelow) {
  SimulatedStrip strip(exact(), kTick, 1);
  EXPECT_EQ(strip.advance(0.1, 1.7), kStripOpen);
  EXPECT_TRUE(std::isfinite(strip.advance(0.1, 1.9)));
  EXPECT_TRUE(std::isfinite(strip.advance(0.1, 0.6)));
  EXPECT_EQ(strip.advance(0.1, 0.4), kStripOpen);
  EXPECT_EQ(strip.advance(0.1, 1.7), kStripOpen);
  EXPECT_EQ(strip.advance(0.1, kNoStrip), kStripOpen);
}

TEST(HoldingStrip, NothingClosesItBesideIt) {
  SimulatedStrip strip(exact(), kTick, 1);
  for (double place : {-0.1, 0.029, 0.171, kNoStrip}) EXPECT_EQ(strip.advance(place, 5), kStripOpen);
}

TEST(HoldingStrip, NoiseIsAsStated) {
  HoldingStripDesc desc;
  desc.noise_ohm = 25;
  SimulatedStrip strip(desc, kTick, 9);
  double squares = 0;
  for (int i = 0; i < 20'000; ++i) squares += std::pow(strip.advance(0.1, 2) - 5050, 2);
  EXPECT_NEAR(std::sqrt(squares / 20'000), 25, 0.5);
}

TEST(HoldingStrip, DropsOutAsOftenAndAsLongAsStated) {
  HoldingStripDesc desc = exact();
  desc.dropout_rate = 2;
  desc.dropout_length = 0.05;
  SimulatedStrip strip(desc, kTick, 4);
  int open = 0, times = 0;
  bool before = false;
  constexpr int kTicks = 1'000'000;
  for (int i = 0; i < kTicks; ++i) {
    const bool now = std::isinf(strip.advance(0.1, 2));
    open += now;
    times += now && !before;
    before = now;
  }
  // Time between two: 1/2 s while it is well; a drop-out of less than a tick is one of a tick.
  const double expected = kTicks * kTick / (0.5 + 0.05);
  EXPECT_NEAR(times, expected, 4 * std::sqrt(expected));
  EXPECT_NEAR(open * kTick / times, 0.05, 0.05 * 4 / std::sqrt(times) + kTick);
}

TEST(HoldingStrip, TheSameSeedIsTheSameStripWhateverTheFingerDoes) {
  HoldingStripDesc desc;
  desc.dropout_rate = 5;
  SimulatedStrip a(desc, kTick, 7), b(desc, kTick, 7), other(desc, kTick, 8);
  bool differs = false;
  for (int i = 0; i < 5000; ++i) {
    const double pressed = a.advance(0.1, 2), seldom = b.advance(0.1, i % 100 == 0 ? 0 : 2);
    if (i % 100 != 0) EXPECT_EQ(pressed, seldom) << i;
    differs = differs || other.advance(0.1, 2) != pressed;
  }
  EXPECT_TRUE(differs);
}

TEST(HoldingStrip, ACalibrationFindsItsTrueEnds) {
  HoldingStripDesc desc;
  desc.tolerance = 0.1;
  SimulatedStrip strip(desc, kTick, 11);
  EXPECT_GT(std::abs(strip.true_high_ohm() - desc.high_ohm), 1) << "it is off until it is calibrated";
  EXPECT_LE(std::abs(strip.true_high_ohm() - desc.high_ohm), 990);
  std::vector<StripPress> presses;
  for (int i = 0; i < 2000; ++i) {
    const double place = 0.03 + 0.14 * (i % 8) / 7.0;
    presses.push_back({place, strip.advance(place, 2)});
  }
  // The simulated ohm are cut off at 0, which no press comes near.
  const std::optional<StripFit> fit = fit_strip(desc, presses);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->low_ohm, strip.true_low_ohm(), 2);
  EXPECT_NEAR(fit->high_ohm, strip.true_high_ohm(), 2);
  EXPECT_NEAR(fit->residual_ohm, 10, 0.7);
  EXPECT_NEAR(fit->residual, 10 * 0.14 / (strip.true_high_ohm() - strip.true_low_ohm()), 2e-5);
}

TEST(HoldingStrip, AFitNeedsTwoPlacesAndAStripThatChanges) {
  const std::vector<StripPress> one{{0.1, 5000}}, same{{0.1, 5000}, {0.1, 5010}},
      flat{{0.1, 5000}, {0.2, 5000}};
  const std::vector<StripPress> open{{0.1, 5000}, {0.15, kStripOpen}}, none;
  for (const auto& presses : {none, one, same, flat, open}) EXPECT_FALSE(fit_strip(exact(), presses));
  const std::vector<StripPress> two{{0.03, 200}, {0.17, 9000}};
  const std::optional<StripFit> fit = fit_strip(exact(), two);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->low_ohm, 200, 1e-9);
  EXPECT_NEAR(fit->high_ohm, 9000, 1e-9);
}

TEST(HoldingStrip, FiguresThatMakeNoStripAreRefused) {
  EXPECT_FALSE(refuse_strip({}));
  for (const HoldingStripDesc& bad :
       {HoldingStripDesc{.low_place = 0.2, .high_place = 0.1}, HoldingStripDesc{.low_ohm = 5, .high_ohm = 5},
        HoldingStripDesc{.closing_force = 1, .opening_force = 2}, HoldingStripDesc{.low_place = kNoStrip}})
    EXPECT_TRUE(refuse_strip(bad));
}

}  // namespace
}  // namespace fulcrum::test
