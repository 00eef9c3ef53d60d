// Pairs of features against distances that are found otherwise: of vertices by the bake's own tree, of edges
// by samples along them. Both ways, at random poses around two parts with corners, grooves and a hole.

#include "haptics/contact/feature_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "haptics/contact/feature_crossings.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/contact/two_parts.h"

namespace fulcrum {
namespace {

TEST(FeaturePairs, TheNearestIsAsFarAsTheSurfacesAre) {
  const Solid tool = brick(), scene = ring();
  FeaturePairs pairs(features(tool), features(scene));
  FeatureCrossings crossings(features(tool), features(scene));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-0.018, 0.018), turn(-3, 3);
  int apart = 0, crossed = 0;
  for (int i = 0; i < 150; ++i) {
    const Pose X_WT{quaternion_exp(Vec3(turn(random), turn(random), turn(random))),
                    Vec3(place(random), place(random) / 2, place(random))};
    const double truth = std::min(least(tool, scene, X_WT), least(scene, tool, X_WT.inverse()));
    ASSERT_TRUE(pairs.look(X_WT, 0.004));
    if (truth < -1e-4) {
      EXPECT_TRUE(crossings.crosses(X_WT)) << i;
      ++crossed;
    } else if (truth > 1e-6 && truth < 0.0039) {
      EXPECT_FALSE(crossings.crosses(X_WT)) << i;
      ASSERT_FALSE(pairs.pairs().empty()) << i;
      const double nearest = std::ranges::min_element(pairs.pairs(), {}, &FeaturePair::gap)->gap;
      EXPECT_LE(nearest, truth + 1e-12) << i;
      EXPECT_GE(nearest, truth - 3e-5) << i;  // what lies between samples
      ++apart;
    }
  }
  EXPECT_GT(apart, 20);
  EXPECT_GT(crossed, 10);
}

// A side that is divided touches as a whole one does: across the places where its edges are cut, and no
// farther than they reach.
TEST(FeaturePairs, ADividedBoxTouchesAsAWholeOneDoes) {
  const Vec3 low(-0.003, -0.002, -0.004), high(0.003, 0.002, 0.004);
  constexpr double kPart = 20e-6;  // m, of the finest edges: less than kDeepest
  const auto tool = features(brick()), box = features(shapes::solid_of(shapes::box(low, high)));
  FeaturePairs whole(tool, box);
  FeatureCrossings crossings(tool, box);
  // Two boxes of parts, of which the second's are short about its middle.
  TriangleMesh mesh = shapes::grid_box(low, high, 8);
  FeaturePairs coarse(tool, features(shapes::solid_of(mesh)));
  for (Vec3& p : mesh.vertices)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (std::abs(p[axis]) < 0.9 * high[axis])
        p[axis] = std::copysign(1.0, p[axis]) * kPart * std::abs(p[axis]) / high[axis];
  FeaturePairs fine(tool, features(shapes::solid_of(mesh)));
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> place(-0.008, 0.008), turn(-3, 3);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose X_WT{quaternion_exp(Vec3(turn(random), turn(random), turn(random))),
                    Vec3(place(random), place(random), place(random))};
    ASSERT_TRUE(whole.look(X_WT, 0.002) && coarse.look(X_WT, 0.002) && fine.look(X_WT, 0.002));
    if (whole.pairs().empty() || crossings.crosses(X_WT) || whole.least_gap() < 0) continue;
    EXPECT_NEAR(coarse.least_gap(), whole.least_gap(), 1e-9) << i;
    EXPECT_NEAR(fine.least_gap(), whole.least_gap(), 1e-9) << i;
    ++apart;
  }
  EXPECT_GT(apart, 100);
}

// What one look leaves over for the next does not change what that finds; nor do candidates that were
// gathered along the way, a part in each look.
TEST(FeaturePairs, AreTheSameHoweverOneCameThere) {
  const auto tool = features(brick()), scene = features(ring());
  FeaturePairs on_the_way(tool, scene), with_foresight(tool, scene), by_leaps(tool, scene);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto near = [&](const Pose& X_WT, double size) {
    return Pose{quaternion_exp(100 * size * Vec3(any(random), any(random), any(random))) * X_WT.q,
                X_WT.p + size * Vec3(any(random), any(random), any(random))};
  };
  const auto pose = [](int i) {
    const double s = 0.01 * i;
    return Pose{quaternion_exp(Vec3(s, 0.3 * s, 0)), Vec3(0.009 + 0.004 * std::cos(3 * s), 0.006, 0.001 * s)};
  };
  const auto ahead_of = [](const Pose& next, const Pose& X_WT) {
    Vec6 ahead;
    ahead << next.p - X_WT.p, rotation_vector(next.q * X_WT.q.conjugate());
    return ahead;
  };
  const auto named = [](std::span<const FeaturePair> pairs, double reach) {
    std::vector<std::pair<std::uint64_t, double>> all;
    for (const FeaturePair& pair : pairs)
      if (pair.gap < reach) all.emplace_back(pair.key, pair.gap);
    std::ranges::sort(all);
    return all;
  };
  std::size_t seen = 0;
  for (int i = 0; i < 400; ++i) {
    const double reach = i % 3 == 0 ? 0.004 : 0.002;
    const Pose X_WT = pose(i), next = pose(i + 1);
    ASSERT_TRUE(on_the_way.look(X_WT, reach));
    // It shakes, now more and now less, or rests.
    for (int leap = 0; leap < i % 5; ++leap)
      ASSERT_TRUE(
          by_leaps.look(near(X_WT, i % 60 < 30 ? 3e-5 : 3e-4), ahead_of(near(X_WT, 1e-4), X_WT), reach));
    ASSERT_TRUE(by_leaps.look(X_WT, reach));
    FeaturePairs at_once(tool, scene);
    ASSERT_TRUE(at_once.look(X_WT, reach));
    ASSERT_TRUE(with_foresight.look(X_WT, ahead_of(next, X_WT), reach));
    const auto expected = named(at_once.pairs(), reach);
    EXPECT_EQ(named(on_the_way.pairs(), reach), expected) << i;
    EXPECT_EQ(named(with_foresight.pairs(), reach), expected) << i;
    EXPECT_EQ(named(by_leaps.pairs(), reach), expected) << i;
    seen += expected.size();
  }
  EXPECT_GT(seen, 100u);
}

// A plate of 30 um, and a spike whose tip is just under it while its shaft leaves past the plate's rim: the
// tip is below the plate's top, too, but has not come in there. Pressed in from above, it has.
TEST(FeaturePairs, OfAThinPlateTellOfTheSideThatATipCameFrom) {
  constexpr double kThickness = 30e-6, kUnder = 10e-6, kWithin = 10e-6;  // m
  const auto plate =
      features(shapes::solid_of(shapes::box(Vec3(-0.01, -kThickness, -0.005), Vec3(0, 0, 0.005))));
  TriangleMesh spike;
  spike.vertices.emplace_back(0, 0, 0);
  const Quat up = quaternion_exp(Vec3(0, 0, 0.25));  // of the shaft, from the plate's plane
  for (const double angle : {0.0, 2.1, 4.2})
    spike.vertices.push_back(up * Vec3(0.005, 4e-4 * std::cos(angle), 4e-4 * std::sin(angle)));
  spike.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  const auto tool = features(shapes::solid_of(spike));
  const Vec3 under(-kWithin, -kThickness - kUnder, 0);
  const auto look = [](FeaturePairs& pairs, const Vec3& p_W) {
    ASSERT_TRUE(pairs.look({Quat::Identity(), p_W}, 15e-6));
  };

  FeaturePairs from_beside(tool, plate);
  for (int i = 20; i >= 0; --i) look(from_beside, under + Vec3(i * 2e-6, 0, 0));
  ASSERT_FALSE(from_beside.pairs().empty());
  EXPECT_GT(from_beside.least_gap(), 5e-6);
  EXPECT_FALSE(FeatureCrossings(tool, plate).crosses({Quat::Identity(), under}));
  // And up, until the shaft nearly touches the rim.
  for (int i = 0; i <= 5; ++i) look(from_beside, under + Vec3(0, i * 1e-6, 0));
  EXPECT_GT(from_beside.least_gap(), 1e-7);
  // Who has not seen it come cannot know.
  FeaturePairs at_once(tool, plate);
  look(at_once, under);
  EXPECT_LT(at_once.least_gap(), -kThickness);

  FeaturePairs from_above(tool, plate);
  for (int i = -10; i <= 10; ++i) look(from_above, Vec3(-1e-3, -i * 1e-6, 0));
  EXPECT_NEAR(from_above.least_gap(), -10e-6, 1e-9);
}

TEST(FeaturePairs, TellOfWhatTheWayAheadMeets) {
  // A cube 1 mm above a plate, which goes down by 1.1 mm in its next step, or along the plate.
  const Solid cube = shapes::solid_of(shapes::box(Vec3(-1e-3, 0, -1e-3), Vec3(1e-3, 2e-3, 1e-3)));
  const Solid plate = shapes::solid_of(shapes::box(Vec3(-1e-2, -1e-3, -1e-2), Vec3(1e-2, 0, 1e-2)));
  FeaturePairs pairs(features(cube), features(plate));
  const Pose X_WT{Quat::Identity(), Vec3(0.0011, 1e-3, 0.0003)};
  Vec6 down = Vec6::Zero(), along = Vec6::Zero(), tipping = Vec6::Zero();
  down[1] = -1.1e-3;
  along[0] = 1.1e-3;
  tipping.tail<3>() = Vec3(0, 0, 0.02);
  tipping[1] = -0.97e-3;  // and 0.02 mm at the corners
  ASSERT_TRUE(pairs.look(X_WT, down, 2e-5));
  EXPECT_GE(pairs.pairs().size(), 4u);
  for (const FeaturePair& pair : pairs.pairs()) EXPECT_NEAR(pair.gap, 1e-3, 1e-12);
  ASSERT_TRUE(pairs.look(X_WT, along, 2e-5));
  EXPECT_TRUE(pairs.pairs().empty());
  ASSERT_TRUE(pairs.look(X_WT, tipping, 2e-5));
  EXPECT_FALSE(pairs.pairs().empty());
  for (const FeaturePair& pair : pairs.pairs())
    EXPECT_LT(pair.p_W.x(), X_WT.p.x()) << "the side that goes down";
  ASSERT_TRUE(pairs.look(X_WT, 2e-5));
  EXPECT_TRUE(pairs.pairs().empty());
}

TEST(FeaturePairs, MovingAsidePressesNoPairTogether) {
  // A cube's face above a plate of several triangles: the corners alone count, not what edges lie in the
  // plate.
  const Solid cube = shapes::solid_of(shapes::box(Vec3(-1e-3, 0, -1e-3), Vec3(1e-3, 2e-3, 1e-3)));
  const Solid plate = shapes::solid_of(shapes::box(Vec3(-1e-2, -1e-3, -1e-2), Vec3(1e-2, 0, 1e-2)));
  const Pose X_WT{Quat::Identity(), Vec3(0.0011, 5e-6, 0.0003)};
  FeaturePairs pairs(features(cube), features(plate));
  ASSERT_TRUE(pairs.look(X_WT, 5e-5));
  EXPECT_FALSE(FeatureCrossings(features(cube), features(plate)).crosses(X_WT));
  EXPECT_GE(pairs.pairs().size(), 4u);
  for (const FeaturePair& pair : pairs.pairs()) {
    EXPECT_NEAR(pair.gap, 5e-6, 1e-12);
    EXPECT_NEAR(pair.nhat_W.y(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace fulcrum
