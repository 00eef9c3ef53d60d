// What a tick's budget allows to be known, and that it is all there is.

#include "haptics/contact/feature_lookahead.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "haptics/contact/feature_pairs.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

class FeatureLookaheadTest : public testing::Test {
protected:
  static std::shared_ptr<const FeatureMesh> features(const TriangleMesh& mesh) {
    const Solid solid = shapes::solid_of(mesh);
    return std::make_shared<const FeatureMesh>(solid.mesh, solid.neighbours);
  }
  Vec3 in_ball(double radius) {
    std::uniform_real_distribution<double> any(-1, 1);
    Vec3 p = Vec3::Ones();
    while (p.norm() > 1) p = Vec3(any(random), any(random), any(random));
    return radius * p;
  }

  std::mt19937_64 random{11};
  // Two fine rings that almost touch all along one of them: many features near each other.
  const std::shared_ptr<const FeatureMesh> tool = features(shapes::torus(0.01, 0.00198, 160, 48)),
                                           scene = features(shapes::torus(0.01, 0.002, 160, 48));
  const Pose beside{Quat::Identity(), Vec3(0, 0.004, 0)};
};

TEST_F(FeatureLookaheadTest, WhatIsTooMuchForOneTickIsKnownSomeTicksLater) {
  FeaturePairs pairs(tool, scene);
  ASSERT_TRUE(pairs.look(beside, 20e-6));
  Vec6 far;
  far << 0.5e-3, 0, 0, 0, 0, 0;
  pairs.begin_tick();
  ASSERT_TRUE(pairs.look(beside, far, 20e-6));
  EXPECT_LT(pairs.ahead().norm(), 0.5 * far.norm());
  int ticks = 1;
  for (; pairs.ahead().norm() < 0.2 * far.norm() && ticks < 100; ++ticks) {
    pairs.begin_tick();
    ASSERT_TRUE(pairs.look(beside, far, 20e-6));
  }
  EXPECT_GT(ticks, 2);
  EXPECT_LT(ticks, 100);
}

// The tool goes anywhere within what it is told, and what is nearest there is what a look finds that has no
// budget.
TEST_F(FeatureLookaheadTest, TheNearestIsThereWithinWhatATickKnows) {
  const double arm = tool->radius();
  FeaturePairs pairs(tool, scene);
  Pose X_WT = beside;
  ASSERT_TRUE(pairs.look(X_WT, 20e-6));
  std::size_t seen = 0, partly = 0;
  for (int tick = 0; tick < 150; ++tick) {
    pairs.begin_tick();
    Vec6 ahead;
    ahead << in_ball(0.3e-3) + 0.3 * (beside.p - X_WT.p), in_ball(0.2e-3) / arm;
    ASSERT_TRUE(pairs.look(X_WT, ahead, 20e-6, 60e-6));
    partly += pairs.ahead().norm() < 0.9 * ahead.norm() ? 1 : 0;
    FeaturePairs at_once(tool, scene);
    ASSERT_TRUE(at_once.look(X_WT, pairs.reach()));
    if (at_once.least_gap() < pairs.reach()) {
      ++seen;
      EXPECT_NEAR(pairs.least_gap(), at_once.least_gap(), 1e-12) << tick;
    }
    // As far as it is free, in one of some ways within what is known.
    for (int way = 0; way < 20; ++way) {
      const Vec6 step = std::uniform_real_distribution<double>(0, 1)(random) * pairs.ahead();
      Pose X_next = ToolWay{.X_WT = X_WT, .step = step}.at(1);
      X_next.p += in_ball(0.5 * pairs.reach());
      X_next.q = (quaternion_exp(in_ball(0.5 * pairs.reach()) / arm) * X_next.q).normalized();
      FeaturePairs there(tool, scene);
      if (!there.look(X_next, 20e-6) || there.least_gap() < 0) continue;
      X_WT = X_next;
      break;
    }
  }
  EXPECT_GT(seen, 50u);
  EXPECT_GT(partly, 20u);
}

}  // namespace
}  // namespace fulcrum
