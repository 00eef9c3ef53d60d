// What goes in on the way between two places that are free, and how far along.

#include "haptics/contact/feature_passing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "haptics/contact/feature_crossings.h"
#include "haptics/contact/feature_pairs.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/contact/two_parts.h"

namespace fulcrum {
namespace {

constexpr double kDepth = 12e-6;  // m

Pose at(const Vec3& p_W) {
  return {Quat::Identity(), p_W};
}

// The part of the way that is free, of which all candidates are known.
double free_part(const Solid& tool, const Solid& scene, const Pose& X_from, const Vec6& step) {
  FeaturePairs pairs(features(tool), features(scene));
  EXPECT_TRUE(pairs.look(X_from, step, 20e-6));
  return pairs.free_part(ToolWay{.X_WT = X_from, .step = step}.at(1), kDepth);
}

Vec6 going(const Vec3& way_W) {
  Vec6 step = Vec6::Zero();
  step.head<3>() = way_W;
  return step;
}

// A blade, of which the edge is 20 um wide and along z.
Solid blade() {
  return shapes::solid_of(shapes::box(Vec3(-10e-6, -1e-3, -1e-3), Vec3(10e-6, 0, 1e-3)));
}

// A wire, 20 um thick and upright.
Solid wire() {
  return shapes::solid_of(shapes::box(Vec3(-10e-6, -1e-3, -10e-6), Vec3(10e-6, 1e-3, 10e-6)));
}

TEST(FeaturePassing, ThinPartsMeetThoughBothEndsOfTheStepAreFree) {
  // The blade's edge and the wire are across each other. From 100 um before the wire to 100 um behind it.
  const Vec3 before(-120e-6, 0, 0), way(240e-6, 0, 0);
  EXPECT_NEAR(free_part(blade(), wire(), at(before), going(way)), (100e-6 + kDepth) / 240e-6, 1e-9);
  // The blade turned along the wire; and the wire as the tool.
  const Pose X_turned{quaternion_exp(Vec3(0.7, 0, 0)), before};
  EXPECT_NEAR(free_part(blade(), wire(), X_turned, going(way)), (100e-6 + kDepth) / 240e-6, 1e-9);
  EXPECT_NEAR(free_part(wire(), blade(), at(before), going(way)), (100e-6 + kDepth) / 240e-6, 1e-9);
  // Past the end of the wire.
  EXPECT_EQ(free_part(blade(), wire(), at(before + Vec3(0, 2.01e-3, 0)), going(way)), 1);
}

TEST(FeaturePassing, ACornerGoesThroughAThinSheet) {
  const Solid sheet = shapes::solid_of(shapes::box(Vec3(-5e-3, -10e-6, -5e-3), Vec3(5e-3, 0, 5e-3)));
  const Solid cube = shapes::solid_of(shapes::box(Vec3(-1e-3, -1e-3, -1e-3), Vec3(1e-3, 1e-3, 1e-3)));
  // The cube's lowest corner is 50 um above.
  const Quat q = quaternion_exp(Vec3(0.4, 0.2, 0.3));
  double low = 0;  // m
  for (const Vec3& p : cube.mesh.vertices) low = std::min(low, (q * p).y());
  const Pose X_WT{q, Vec3(0, 50e-6 - low, 0)};
  EXPECT_NEAR(free_part(cube, sheet, X_WT, going(Vec3(0, -0.2e-3, 0))), (50e-6 + kDepth) / 0.2e-3, 1e-9);
  EXPECT_NEAR(free_part(sheet, cube, X_WT.inverse(), going(q.conjugate() * Vec3(0, 0.2e-3, 0))),
              (50e-6 + kDepth) / 0.2e-3, 1e-6);
  EXPECT_EQ(free_part(cube, sheet, X_WT, going(Vec3(0, -61e-6, 0))), 1) << "in by less";
  EXPECT_EQ(free_part(cube, sheet, X_WT, going(Vec3(0.2e-3, 0, 0))), 1) << "along it";
}

// What is in by a little may be in by a little more, and no deeper.
TEST(FeaturePassing, WhatIsInGoesNoDeeper) {
  constexpr double kIn = 8e-6;  // m
  const Solid plate = shapes::solid_of(shapes::box(Vec3(-5e-3, -1e-3, -5e-3), Vec3(5e-3, 0, 5e-3)));
  const Solid cube = shapes::solid_of(shapes::box(Vec3(-1e-3, 0, -1e-3), Vec3(1e-3, 1e-3, 1e-3)));
  FeaturePairs pairs(features(cube), features(plate));
  const Vec3 before(0.1e-3, 1e-6, 0.2e-3);
  ASSERT_TRUE(pairs.look(at(before), going(Vec3(0, -0.2e-3, 0)), 20e-6));
  ASSERT_TRUE(pairs.look(at(Vec3(0.1e-3, -kIn, 0.2e-3)), going(Vec3(0, -0.2e-3, 0)), 20e-6));
  ASSERT_NEAR(pairs.least_gap(), -kIn, 1e-12);
  EXPECT_NEAR(pairs.free_part(at(Vec3(0.1e-3, -0.2e-3, 0.2e-3)), kDepth), (kDepth - kIn) / (0.2e-3 - kIn),
              1e-9);
  EXPECT_EQ(pairs.free_part(at(Vec3(0.3e-3, -kIn, 0.2e-3)), kDepth), 1);
}

// Any way of two parts that turn: no place on the free part is in by more than the depth, judged by the
// bake's own tree; and where it ends the two are in each other.
TEST(FeaturePassing, EndsWhereThePartsGoIn) {
  constexpr int kWays = 160, kPlaces = 12;
  constexpr double kTurn = 0.03;                 // rad, at most
  constexpr double kBow = 0.01 * kTurn * kTurn;  // m, of points' ways at most
  const Solid tool = brick(), scene = ring();
  FeatureCrossings crossings(features(tool), features(scene));
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-0.018, 0.018), turn(-3, 3), step(-2e-3, 2e-3), any(-1, 1);
  int stopped = 0, free = 0;
  while (stopped + free < kWays) {
    const Pose X_WT{quaternion_exp(Vec3(turn(random), turn(random), turn(random))),
                    Vec3(place(random), place(random) / 2, place(random))};
    const double apart = std::min(least(tool, scene, X_WT, 8), least(scene, tool, X_WT.inverse(), 8));
    if (!(apart > 0 && apart < 1.5e-3) || crossings.crosses(X_WT)) continue;
    ToolWay way{.X_WT = X_WT};
    way.step << step(random), step(random), step(random),
        0.5 * kTurn * Vec3(any(random), any(random), any(random));
    const double part = free_part(tool, scene, X_WT, way.step);
    for (int i = 1; i <= kPlaces; ++i) {
      const Pose X_on_way = way.at(part * i / kPlaces);
      EXPECT_GT(std::min(least(tool, scene, X_on_way, 12), least(scene, tool, X_on_way.inverse(), 12)),
                -kDepth - kBow)
          << stopped + free << ' ' << i;
    }
    if (part < 1) EXPECT_TRUE(crossings.crosses(way.at(part))) << stopped + free;
    ++(part < 1 ? stopped : free);
  }
  EXPECT_GT(stopped, 15);
  EXPECT_GT(free, 15);
}

}  // namespace
}  // namespace fulcrum
