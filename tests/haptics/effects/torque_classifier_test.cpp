// Recorded wrenches with known answers: a lever against R_d, a force along the torque, a pure couple; and
// wrenches on the border, which must not chatter.

#include "haptics/effects/torque_substitution/torque_classifier.h"
#include "tests/haptics/tick_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace fulcrum::test {
namespace {

constexpr TorqueBounds kBounds{.torque = 0.03, .radius = 0.02, .contact = 0.003};  // N m, m, N m

bool first_says(const Wrench& F_T_W, const TorqueBounds& bounds = kBounds) {
  return TorqueClassifier(bounds, kTick).update(-F_T_W.torque, F_T_W);
}

// A force at a lever: on the tool, about T.
Wrench force_at(const Vec3& lever, const Vec3& force) {
  return {force, lever.cross(force)};
}

TEST(TorqueClassifier, ALeverLongerThanTheToolIsBad) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 lever_hat = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 force = 5.0 * lever_hat.unitOrthogonal();
    EXPECT_FALSE(first_says(force_at(0.99 * kBounds.radius * lever_hat, force)));
    EXPECT_TRUE(first_says(force_at(1.01 * kBounds.radius * lever_hat, force)));
  }
}

TEST(TorqueClassifier, AForceAlongTheTorqueDoesNotCount) {
  for (const double along : {-100.0, -1.0, 0.0, 1.0, 100.0})
    EXPECT_TRUE(first_says({Vec3(0, 0, along), Vec3(0, 0, 0.05)})) << along;
  // Across it the same force explains it, and the torque's length must not come into the projection: Eq. 1
  // as printed subtracts N^2 m.
  EXPECT_FALSE(first_says({Vec3(3, 0, 100), Vec3(0, 0, 0.05)}));
  EXPECT_TRUE(first_says({Vec3(2, 0, 100), Vec3(0, 0, 0.05)}));
}

TEST(TorqueClassifier, APureCoupleIsBadFromTheThresholdOn) {
  EXPECT_FALSE(first_says({Vec3::Zero(), Vec3(0, 0.0299, 0)}));
  EXPECT_TRUE(first_says({Vec3::Zero(), Vec3(0, 0.0301, 0)}));
}

TEST(TorqueClassifier, WithoutContactNothingIsBad) {
  TorqueClassifier classifier(kBounds, kTick);
  EXPECT_FALSE(classifier.update(Vec3::Zero(), {Vec3::Zero(), Vec3(0, 1, 0)}));
  EXPECT_FALSE(classifier.update(Vec3(0, 0.0029, 0), {Vec3::Zero(), Vec3(0, 1, 0)}));
  EXPECT_TRUE(classifier.update(Vec3(0, 0.0031, 0), {Vec3::Zero(), Vec3(0, 1, 0)}));
}

TEST(TorqueClassifier, NothingAndNotANumberAreGood) {
  EXPECT_FALSE(first_says({}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(first_says({Vec3::Zero(), Vec3(nan, 1, 0)}));
  EXPECT_FALSE(first_says({Vec3(nan, 0, 0), Vec3(0, 1, 0)}));
}

// Noise of 5 % about the threshold: without hysteresis it would change some hundred times a second.
TEST(TorqueClassifier, DoesNotChatterOnTheBorder) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  TorqueClassifier classifier(kBounds, kTick);
  int changes = 0;
  bool before = false;
  for (int i = 0; i < 10000; ++i) {
    const double torque = kBounds.torque * (1 + 0.05 * normal(random));
    const bool bad = classifier.update(Vec3(0, 0, torque), {Vec3::Zero(), Vec3(0, 0, torque)});
    changes += bad != before;
    before = bad;
  }
  EXPECT_EQ(changes, 1);
}

// Stiff contact lets go in every third tick.
TEST(TorqueClassifier, ContactThatLetsGoForSingleTicksStaysBad) {
  for (const double tick_s : {1e-3, 0.1e-3}) {
    TorqueClassifier classifier(kBounds, tick_s);
    const Wrench wound{Vec3::Zero(), Vec3(0, 0, 0.1)};
    ASSERT_TRUE(classifier.update(Vec3(0, 0, -0.1), wound));
    for (int i = 0; i < 1000; ++i)
      ASSERT_TRUE(classifier.update(i % 3 == 0 ? Vec3(Vec3::Zero()) : Vec3(0, 0, -0.1), wound));
    int ticks = 0;
    while (classifier.update(Vec3::Zero(), wound)) ++ticks;
    EXPECT_NEAR((ticks + 1) * tick_s, TorqueClassifier::kHold, 1.5 * tick_s);
  }
}

}  // namespace
}  // namespace fulcrum::test
