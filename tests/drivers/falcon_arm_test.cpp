// A Falcon's geometry, against its legs as chains of vectors: nine equations for the grip's place and six
// angles, which are solved here by differences. The driver knows three lengths and nothing of those angles.

#include "drivers/falcon/falcon_arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "drivers/falcon/falcon_packets.h"
#include "engine/scenario/load.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::test {
namespace {

using LegCounts = std::array<int, 3>;
using Unknowns = Eigen::Matrix<double, 9, 1>;  // place, then each leg's two other angles

constexpr double kDeg = std::numbers::pi / 180;

// From the base to the arm's axis, along the arm, across the joint, along the shin, across the other joint,
// and back to the grip's middle: where each leg puts the grip, less where it is.
Unknowns gaps(const Unknowns& x, const LegCounts& counts) {
  Unknowns gap;
  const double directions[] = {105, -15, -135};
  for (int leg = 0; leg < 3; ++leg) {
    const double arm = (35 + 0.036435 * counts[static_cast<std::size_t>(leg)]) * kDeg;
    const double shin = x[3 + 2 * leg], slant = x[4 + 2 * leg];
    const Vec3 in_leg =
        Vec3(0.040, -0.02309, 0) + 0.060 * Vec3(std::cos(arm), 0, std::sin(arm)) +
        (0.01125 + 0.01125) * Vec3(std::cos(shin), 0, std::sin(shin)) +
        0.1025 * Vec3(std::sin(slant) * std::cos(shin), std::cos(slant), std::sin(slant) * std::sin(shin)) +
        Vec3(-0.01443, 0.025, 0);
    const Eigen::AngleAxisd turn(directions[leg] * kDeg, Vec3::UnitZ());
    gap.segment<3>(3 * leg) = turn * in_leg - x.head<3>();
  }
  return gap;
}

// m, 0.125 m before the base; from anywhere near the middle.
Vec3 place_of(const LegCounts& counts) {
  Unknowns x;
  x << 0, 0, 0.12, 1.8, 1.6, 1.8, 1.6, 1.8, 1.6;
  for (int step = 0; step < 60; ++step) {
    Eigen::Matrix<double, 9, 9> slope;
    for (int i = 0; i < 9; ++i) {
      const Unknowns by = 1e-6 * Unknowns::Unit(i);
      slope.col(i) = (gaps(x + by, counts) - gaps(x - by, counts)) / 2e-6;
    }
    Unknowns by = slope.fullPivLu().solve(-gaps(x, counts));
    if (by.norm() > 0.2) by *= 0.2 / by.norm();
    x += by;
  }
  EXPECT_LT(gaps(x, counts).norm(), 1e-10) << "this solution is none";
  return x.head<3>() - Vec3(0, 0, 0.125);
}

// Within the workspace, as counts from 0 to 35 deg apart.
LegCounts some_counts(SplitMix& random) {
  const auto within = [&] { return static_cast<int>(-700 + 1300 * random.uniform()); };
  return {within(), within(), within()};
}

TEST(FalconArm, ThePlaceIsWhereTheLegsMeet) {
  SplitMix random(17);
  for (int n = 0; n < 300; ++n) {
    const LegCounts counts = some_counts(random);
    const auto stance = falcon::stance_at(counts);
    ASSERT_TRUE(stance) << counts[0] << " " << counts[1] << " " << counts[2];
    EXPECT_LT((stance->p_DH - place_of(counts)).norm(), 1e-8);
  }
}

// Legs alike: the grip is on the axis, and further out the more they are turned. A leg that is drawn in
// draws the grip to its side: the first is above, the second at the right, the third at the lower left.
TEST(FalconArm, RightIsXUpIsYAndToThePersonIsZ) {
  double before = -1;
  for (const int count : {-1200, -600, 0, 600, 1000}) {
    const auto stance = falcon::stance_at({count, count, count});
    ASSERT_TRUE(stance);
    EXPECT_LT(stance->p_DH.head<2>().norm(), 1e-9);
    EXPECT_GT(stance->p_DH.z(), before);
    before = stance->p_DH.z();
  }
  EXPECT_NEAR(falcon::stance_at({0, 0, 0})->p_DH.z(), 0.1346 - 0.125, 1e-4);
  const double directions[] = {105, -15, -135};
  for (std::size_t leg = 0; leg < 3; ++leg) {
    LegCounts counts{0, 0, 0};
    counts[leg] = -300;
    const Vec3 p = falcon::stance_at(counts)->p_DH;
    EXPECT_GT(p.x() * std::cos(directions[leg] * kDeg) + p.y() * std::sin(directions[leg] * kDeg), 0.003);
  }
}

TEST(FalconArm, TheJacobianIsTheDifferenceOfPlaces) {
  SplitMix random(5);
  for (int n = 0; n < 100; ++n) {
    const LegCounts counts = some_counts(random);
    const auto stance = falcon::stance_at(counts);
    ASSERT_TRUE(stance);
    for (std::size_t leg = 0; leg < 3; ++leg) {
      LegCounts less = counts, more = counts;
      less[leg] -= 2;
      more[leg] += 2;
      const Vec3 by_angle = (place_of(more) - place_of(less)) / (4 * 0.036435 * kDeg);
      const Vec3 column = stance->J_D.col(static_cast<Eigen::Index>(leg));
      EXPECT_LT((column - by_angle).norm(), 1e-3 * by_angle.norm());
    }
  }
}

// A leg that turns by some counts does the work that the force does on the way which the grip goes by it; a
// motor's value is -10000 for a N m.
TEST(FalconArm, WhatTheMotorsDoIsWhatTheGripFeels) {
  SplitMix random(4);
  for (int n = 0; n < 200; ++n) {
    const LegCounts counts = some_counts(random);
    const Vec3 force(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const auto motors = falcon::motors_for(*falcon::stance_at(counts), force);
    for (std::size_t leg = 0; leg < 3; ++leg) {
      LegCounts less = counts, more = counts;
      less[leg] -= 2;
      more[leg] += 2;
      const double at_grip = force.dot(place_of(more) - place_of(less));
      const double at_motor = -1e-4 * motors[leg] * 4 * 0.036435 * kDeg;
      EXPECT_NEAR(at_motor, at_grip, 1e-3 * std::abs(at_grip) + 0.51e-4 * 4 * 0.036435 * kDeg);
    }
  }
}

TEST(FalconArm, TooMuchForceKeepsItsDirection) {
  const auto stance = falcon::stance_at({-100, 50, 200});
  ASSERT_TRUE(stance);
  const Vec3 force(3, -20, 10);
  const auto motors = falcon::motors_for(*stance, force), tenfold = falcon::motors_for(*stance, 1e9 * force);
  int most = 0;
  for (const int motor : motors) most = std::max(most, std::abs(motor));
  EXPECT_EQ(most, falcon::kMostMotor);
  const Vec3 torque(motors[0], motors[1], motors[2]);
  const Vec3 made = stance->J_D.transpose().inverse() * torque;
  EXPECT_LT((made.normalized() + force.normalized()).norm(), 1e-3);
  for (const int motor : tenfold) EXPECT_LE(std::abs(motor), falcon::kMostMotor);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(falcon::motors_for(*stance, {1, bad, 0}), (LegCounts{})) << bad;
}

// Any counts are a place of a Falcon, at which its motors can be told what to do, or none.
TEST(FalconArm, CountsOfNoFalconAreRefused) {
  EXPECT_FALSE(falcon::stance_at({32767, 32767, 32767}));
  EXPECT_FALSE(falcon::stance_at({-32768, 0, 0}));
  EXPECT_FALSE(falcon::stance_at({2000, 2000, 2000})) << "the legs are stretched";
  SplitMix random(9);
  int places = 0;
  for (int n = 0; n < 100000; ++n) {
    const auto any = [&] { return static_cast<int>(-4000 + 7000 * random.uniform()); };
    const auto stance = falcon::stance_at({any(), any(), any()});
    if (!stance) continue;
    ++places;
    ASSERT_LT(stance->p_DH.norm(), 0.2);
    ASSERT_LT(stance->J_D.norm(), 2);
  }
  EXPECT_GT(places, 1000);
  EXPECT_LT(places, 99000);
}

// The table's largest force is one that the motors have in the middle, whatever its direction; its encoder
// step is a count's.
TEST(FalconArm, TheTableSaysWhatTheGeometryGives) {
  const auto table = scenario::load_device(std::filesystem::path(FULCRUM_SOURCE_DIR) / "content" / "devices" /
                                           "falcon.yaml");
  ASSERT_TRUE(table);
  const LegCounts middle{-200, -200, -200};
  const auto stance = falcon::stance_at(middle);
  ASSERT_TRUE(stance);
  ASSERT_LT(stance->p_DH.norm(), 1e-3);
  SplitMix random(2);
  double weakest = 1e9;
  for (int n = 0; n < 5000; ++n) {
    const Vec3 direction =
        (Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Constant(0.5)).normalized();
    const Vec3 torque = stance->J_D.transpose() * direction;
    weakest = std::min(weakest, 1e-4 * falcon::kMostMotor / torque.cwiseAbs().maxCoeff());
  }
  EXPECT_LE(table->max_force, weakest);
  EXPECT_GE(table->max_force, 0.95 * weakest);
  for (std::size_t leg = 0; leg < 3; ++leg) {
    LegCounts counts = middle;
    ++counts[leg];
    EXPECT_NEAR((place_of(counts) - place_of(middle)).norm(), table->encoder_step, 1e-6);
  }
}

}  // namespace
}  // namespace fulcrum::test
