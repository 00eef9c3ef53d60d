// Reference: a first-order lag in closed form. A push that begins at t = 0 has moved the handle by
// v (t - tau (1 - e^(-t/tau))).

#include "drivers/rate/rate_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

constexpr double kTick = 1e-3;

Pose pushed_for(double s, const PushedAxes& axes, const SeenFrame& seen, double tick_s = kTick) {
  RateControl rate(RateControlDesc(), Pose{}, tick_s);
  for (int tick = 0; tick < static_cast<int>(std::lround(s / tick_s)); ++tick) rate.advance(axes, seen);
  return rate.X_WH();
}

double way(double v, double t) {
  const double lag = RateControlDesc().lag;
  return v * (t - lag * (1 - std::exp(-t / lag)));
}

TEST(RateControl, MovesAsFastAsItIsPushedWhateverTheTick) {
  const SeenFrame seen{.height = 0.4};
  for (const double tick_s : {1e-4, 1e-3, 1e-2}) {
    const Pose X_WH = pushed_for(0.5, {.way = {1, 0, 0}}, seen, tick_s);
    EXPECT_NEAR(X_WH.p.x(), way(0.5 * 0.4, 0.5), 0.2 * tick_s) << "half a picture's height in a second";
    EXPECT_EQ(X_WH.p.y(), 0);
    EXPECT_EQ(X_WH.p.z(), 0);
  }
}

TEST(RateControl, HalfAPushIsAQuarterOfTheSpeed) {
  const SeenFrame seen{};
  const double full = pushed_for(1, {.way = {0, -1, 0}}, seen).p.y();
  EXPECT_LT(full, 0);
  EXPECT_NEAR(pushed_for(1, {.way = {0, -0.5, 0}}, seen).p.y(), full / 4, 1e-12);
  EXPECT_NEAR(pushed_for(1, {.way = {0, 0.5, 0}}, seen).p.y(), -full / 4, 1e-12);
}

// The camera looks along -x: its right is -z, toward the person is x.
TEST(RateControl, GoesByWhatIsSeen) {
  const Quat q_WV(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
  const Pose X_WH = pushed_for(1, {.way = {1, 0, 0}, .turn = {0, 0, 1}}, {.q_WV = q_WV});
  EXPECT_GT(-X_WH.p.z(), 0.05);
  EXPECT_NEAR(X_WH.p.x(), 0, 1e-12);
  const Vec3 turned = rotation_vector(X_WH.q);
  EXPECT_NEAR(turned.x(), way(1.6, 1), 1e-2);
  EXPECT_NEAR(turned.y(), 0, 1e-9);
  EXPECT_NEAR(turned.z(), 0, 1e-9);
}

TEST(RateControl, WhileTheToolRestsNothingPushesIt) {
  const Pose X_WH = pushed_for(1, {.way = Vec3::Ones(), .turn = Vec3::Ones()}, {.rests = true});
  EXPECT_TRUE(X_WH.p.isZero(0));
  EXPECT_EQ(X_WH.q.w(), 1);
}

TEST(RateControl, WhatIsNoNumberOrTooMuchIsNoWayOut) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const Pose none = pushed_for(1, {.way = {kNaN, kInfinite, -kInfinite}, .turn = {kNaN, kNaN, kNaN}}, {});
  EXPECT_TRUE(none.p.isZero(0));
  EXPECT_EQ(none.q.w(), 1);
  const Pose most = pushed_for(1, {.way = {1, 0, 0}}, {});
  EXPECT_EQ(pushed_for(1, {.way = {1e300, 0, 0}}, {}).p, most.p);
}

}  // namespace
}  // namespace fulcrum::test
