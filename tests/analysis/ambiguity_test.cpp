// A bar along x, struck from above at one end and from below at the other: held in the middle both turn the
// hand about z, as far away, and feel alike; held at an end they differ by their distance, and struck both
// from above by the sign of their axes.

#include "engine/analysis/ambiguity/ambiguity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum::analysis::ambiguity {
namespace {

const ImpactSite kRight{Vec3(0.1, 0, 0), Vec3::UnitY()};
const ImpactSite kLeft{Vec3(-0.1, 0, 0), -Vec3::UnitY()};

TEST(Ambiguity, HeldInTheMiddleBothEndsFeelAlike) {
  const ImpactSite sites[] = {kRight, kLeft};
  const PointScore middle = score_point(sites, Vec3::Zero(), {});
  EXPECT_EQ(middle.confused, 1);
  EXPECT_EQ(middle.alike, 1);
  EXPECT_NEAR(middle.mistaken, 0.2, 1e-15);
  EXPECT_EQ(middle.without_axis, 0);
  const PointScore end = score_point(sites, Vec3(-0.15, 0, 0), {});
  EXPECT_EQ(end.confused, 0);
  EXPECT_EQ(end.alike, 0);
  EXPECT_EQ(end.mistaken, 0);
}

TEST(Ambiguity, OppositeAxesAreToldApart) {
  const ImpactSite sites[] = {kRight, {kLeft.p_T, Vec3::UnitY()}};
  EXPECT_EQ(score_point(sites, Vec3::Zero(), {}).confused, 0);
}

// A disc whose rim is struck along its axis, held in the middle: each place has an axis of its own. Struck
// towards the middle: no axis anywhere, and the force tells.
TEST(Ambiguity, ARimHasAnAxisForEachPlaceOrNone) {
  std::vector<ImpactSite> along, inwards;
  for (int i = 0; i < 36; ++i) {
    const double angle = i * std::numbers::pi / 18;
    const Vec3 e(std::cos(angle), 0, std::sin(angle));
    along.push_back({0.1 * e, Vec3::UnitY()});
    inwards.push_back({0.1 * e, -e});
  }
  const PointScore of_along = score_point(along, Vec3::Zero(), {});
  EXPECT_EQ(of_along.confused, 0);
  EXPECT_EQ(of_along.without_axis, 0);
  const PointScore of_inwards = score_point(inwards, Vec3::Zero(), {});
  EXPECT_EQ(of_inwards.confused, 0);
  EXPECT_EQ(of_inwards.without_axis, 1);
}

TEST(Ambiguity, RanksTheLeastAlikeFirst) {
  const ImpactSite sites[] = {kRight, kLeft};
  const Vec3 candidates[] = {Vec3::Zero(), Vec3(-0.15, 0, 0), Vec3(0.15, 0, 0)};
  const std::vector<PointScore> ranked = rank_points(sites, candidates, {});
  ASSERT_EQ(ranked.size(), 3u);
  EXPECT_EQ(ranked[0].p_T, candidates[1]);
  EXPECT_EQ(ranked[1].p_T, candidates[2]) << "equal ones in their order";
  EXPECT_EQ(ranked[2].p_T, candidates[0]);
  EXPECT_EQ(ranked[2].alike, 1);
}

TEST(Ambiguity, NothingStruckIsNothingConfused) {
  const PointScore score = score_point({}, Vec3::Zero(), {});
  EXPECT_EQ(score.confused, 0);
  EXPECT_EQ(score.alike, 0);
}

}  // namespace
}  // namespace fulcrum::analysis::ambiguity
