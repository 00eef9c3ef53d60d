// Cones of normals against samples of the directions in them.

#include "haptics/geometry/normal_cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum {
namespace {

Vec3 any_direction(SplitMix& random) {
  for (;;) {
    const Vec3 v(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

// In the cone, `part` of its angle off the axis.
Vec3 in(const NormalCone& cone, double part, SplitMix& random) {
  const Vec3 aside = cone.axis().cross(any_direction(random)).normalized();
  return turn_by(part * cone.angle(), aside) * cone.axis();
}

TEST(NormalCone, HoldsAllThatItIsAbout) {
  SplitMix random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 middle = any_direction(random);
    std::vector<Vec3> directions;
    for (int k = 0; k < 5; ++k) directions.push_back((middle + 0.9 * any_direction(random)).normalized());
    const NormalCone cone = NormalCone::about(directions);
    for (const Vec3& direction : directions)
      EXPECT_LE(angle_between(cone.axis(), direction), cone.angle()) << i;
  }
  EXPECT_TRUE(NormalCone::about({}).none());
}

TEST(NormalCone, OfTwoHoldsBothAndIsNoWiderThanItNeedBe) {
  SplitMix random(2);
  for (int i = 0; i < 300; ++i) {
    const NormalCone a(any_direction(random), 1.2 * random.uniform()),
        b(any_direction(random), 1.2 * random.uniform()), both = NormalCone::about(a, b);
    for (const NormalCone& cone : {a, b})
      for (int k = 0; k < 20; ++k)
        EXPECT_LE(angle_between(both.axis(), in(cone, 1, random)), both.angle() + 1e-9) << i;
    const double between = angle_between(a.axis(), b.axis());
    EXPECT_LE(both.angle(), std::max({a.angle(), b.angle(), (a.angle() + between + b.angle()) / 2}) + 1e-8);
  }
  EXPECT_TRUE(NormalCone::about(NormalCone(), NormalCone()).none());
}

TEST(NormalCone, OpposesWhatHasAnOppositeInTheOther) {
  SplitMix random(3);
  int opposed = 0, apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const NormalCone a(any_direction(random), random.uniform()), b(any_direction(random), random.uniform()),
        slack(Vec3::UnitX(), 0.3 * random.uniform());
    // The least angle between a direction of the one and the opposite of one of the other.
    const double least = angle_between(a.axis(), Vec3(-b.axis())) - a.angle() - b.angle();
    if (std::abs(least - slack.angle()) < 1e-6) continue;
    EXPECT_EQ(a.opposes(a.axis(), b, slack), least < slack.angle()) << i;
    ++(least < slack.angle() ? opposed : apart);
  }
  EXPECT_GT(opposed, 500);
  EXPECT_GT(apart, 500);
}

TEST(NormalCone, OfDirectionsAllAroundIsAllOfThem) {
  const std::vector<Vec3> around{Vec3::UnitX(), -Vec3::UnitX()};
  const NormalCone all = NormalCone::about(around), needle(Vec3::UnitY());
  EXPECT_TRUE(all.opposes(all.axis(), needle, NormalCone(Vec3::UnitX())));
  EXPECT_TRUE(needle.opposes(needle.axis(), all, NormalCone(Vec3::UnitX())));
}

}  // namespace
}  // namespace fulcrum
