#include "engine/report/axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fulcrum::report {
namespace {

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> found;
  for (const Tick& tick : axis.ticks())
    if (!tick.label.empty()) found.push_back(tick.label);
  return found;
}

Axis over(Scale scale, std::vector<double> values) {
  return {AxisDesc{.title = "x", .unit = "m", .scale = scale, .low = {}, .high = {}}, values};
}

TEST(Axis, LinearTicksAreRoundAndHoldTheValues) {
  const Axis axis = over(Scale::linear, {0.13, 4.9});
  EXPECT_EQ(axis.low(), 0);
  EXPECT_EQ(axis.high(), 5);
  EXPECT_EQ(labels(axis), (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(labels(over(Scale::linear, {-0.3, 0.3})),
            (std::vector<std::string>{"−0.3", "−0.2", "−0.1", "0", "0.1", "0.2", "0.3"}));
}

TEST(Axis, AGivenEndIsPartOfWhatItHolds) {
  const Axis axis({.title = "x", .unit = "m", .low = 0.0, .high = {}}, std::vector<double>{61.9, 62.1});
  EXPECT_EQ(axis.low(), 0);
  EXPECT_EQ(labels(axis), (std::vector<std::string>{"0", "20", "40", "60", "80"})) << "not steps of 0.05";
}

TEST(Axis, NamesStandAtTheirPlaces) {
  AxisDesc desc;
  desc.names = {"A", "B", "C"};
  const Axis axis(desc, std::vector<double>{0, 2.2});
  EXPECT_EQ(labels(axis), desc.names);
  EXPECT_NEAR(axis.place(0), 1.0 / 6, 1e-12);
  EXPECT_NEAR(axis.place(1), 0.5, 1e-12);
  EXPECT_EQ(axis.ticks()[2].value, 2);
}

TEST(Axis, LogarithmicTicksArePowersOfTenWithTheirMultiplesBetween) {
  const Axis axis = over(Scale::logarithmic, {1e-3, 1e3});
  EXPECT_EQ(labels(axis), (std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10", "100", "1000"}));
  const std::vector<Tick> ticks = axis.ticks();
  ASSERT_EQ(ticks.size(), 6u * 9 + 1);
  EXPECT_EQ(ticks[1].value, 2e-3);
  EXPECT_EQ(ticks[9].value, 1e-2);
  EXPECT_TRUE(ticks[1].label.empty());
  for (std::size_t i = 0; i + 9 < ticks.size(); ++i)  // a decade is as wide anywhere
    EXPECT_NEAR(axis.place(ticks[i + 9].value) - axis.place(ticks[i].value), 1.0 / 6, 1e-12);
}

TEST(Axis, ShortLogarithmicAxesSayMoreAndLongOnesLess) {
  EXPECT_EQ(labels(over(Scale::logarithmic, {1, 10})), (std::vector<std::string>{"1", "2", "5", "10"}));
  EXPECT_EQ(labels(over(Scale::logarithmic, {2, 5})), (std::vector<std::string>{"2", "3", "4", "5"}));
  const std::vector<std::string> few = labels(over(Scale::logarithmic, {1e-15, 1e15}));
  EXPECT_GE(few.size(), 4u);
  EXPECT_LE(few.size(), 12u);
  EXPECT_EQ(few.front(), "10⁻¹⁵");
}

TEST(Axis, EndsAreTheNearestRoundValues) {
  const Axis axis = over(Scale::logarithmic, {0.034, 340});
  EXPECT_NEAR(axis.low(), 0.02, 1e-15);
  EXPECT_NEAR(axis.high(), 500, 1e-12);
}

TEST(Axis, WhatItCannotShowCountsForNothing) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const Axis axis = over(Scale::logarithmic, {-1, 0, nan, inf, 10, 100});
  EXPECT_EQ(axis.low(), 10);
  EXPECT_EQ(axis.high(), 100);
  EXPECT_FALSE(axis.shows(0));
  EXPECT_FALSE(axis.shows(nan));
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    for (const std::vector<double>& values : {std::vector<double>{}, {5}, {0}, {nan}}) {
      const Axis one = over(scale, values);
      EXPECT_LT(one.low(), one.high());
      EXPECT_FALSE(labels(one).empty());
    }
  }
}

TEST(ShortNumber, IsWhatAPersonWouldWrite) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(0.02), "0.02");
  EXPECT_EQ(short_number(-0.3), "−0.3");
  EXPECT_EQ(short_number(1000.834, 4), "1001");
  EXPECT_EQ(short_number(4905.3, 2), "4900");
  EXPECT_EQ(short_number(1e6), "10⁶");
  EXPECT_EQ(short_number(2.5e-7), "2.5·10⁻⁷");
  EXPECT_EQ(short_number(std::nan("")), "—");
}

}  // namespace
}  // namespace fulcrum::report
