// Bounds that are moved hold what they held, whatever single precision rounds, and little more; a tree has
// each feature once, within the bounds of all groups above it.

#include "haptics/geometry/feature_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "haptics/geometry/bounds-inl.h"
#include "haptics/math/pose.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

class Dice {
public:
  double from_to(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Vec3 in_cube(double half) { return Vec3(from_to(-half, half), from_to(-half, half), from_to(-half, half)); }
  Vec3 direction() {
    Vec3 way = in_cube(1);
    while (way.norm() < 0.1 || way.norm() > 1) way = in_cube(1);
    return way.normalized();
  }
  // A unit vector at that angle (rad) of another.
  Vec3 beside(const Vec3& axis, double angle) {
    const Vec3 across = axis.cross(direction()).normalized();
    return std::cos(angle) * axis + std::sin(angle) * across;
  }
  Pose pose() { return {turn_by(from_to(0, 3), direction()), in_cube(0.3)}; }

private:
  std::mt19937 random_{7};
};

Bounds at(const Vec3& p, const Vec3& axis) {
  return Bounds::of(Box3(p, p), NormalCone(axis));
}

// In one lane of four.
constexpr unsigned kOther = 3;
Bounds4 alone(const Bounds& bounds) {
  Bounds4 four;
  four.set(kOther, bounds);
  return four;
}

class SweptBounds : public testing::Test {
protected:
  static constexpr double kReach = 1e-4, kTurn = 0.01, kSlack = 0.05;
  static constexpr unsigned kLane = 2;

  // longest: rad and m / 10, of the way.
  void roll(double longest, double turn) {
    const Vec3 low = dice.in_cube(0.02);
    box_T = Box3(low, low + Vec3(dice.from_to(0, 0.01), dice.from_to(0, 0.01), dice.from_to(0, 0.01)));
    axis_T = dice.direction();
    angle = dice.from_to(0, 1.4);
    X_WT = dice.pose();
    way_turn = dice.from_to(0, longest) * dice.direction();
    way = dice.in_cube(0.1 * longest);
    Bounds4 four;
    four.set(kLane, Bounds::of(box_T, NormalCone(axis_T, angle)));
    swept = four.swept({.R_from = at_part(0).q.toRotationMatrix(),
                        .R_middle = at_part(0.5).q.toRotationMatrix(),
                        .R_to = at_part(1).q.toRotationMatrix(),
                        .p_from = at_part(0).p,
                        .p_to = at_part(1).p,
                        .reach = kReach,
                        .turn = turn + way_turn.squaredNorm() / 8,
                        .slack = NormalCone(Vec3::UnitX(), kSlack + 0.5 * way_turn.norm())});
  }
  Pose at_part(double part) const { return {quaternion_exp(part * way_turn) * X_WT.q, X_WT.p + part * way}; }
  Vec3 place_T() {
    return box_T.min() +
           Vec3(dice.from_to(0, 1), dice.from_to(0, 1), dice.from_to(0, 1)).cwiseProduct(box_T.sizes());
  }
  bool meets(const Vec3& p_W, const Vec3& axis_W) const { return swept.meeting(alone(at(p_W, axis_W))) != 0; }

  Dice dice;
  Box3 box_T;
  Vec3 axis_T = Vec3::UnitX();
  double angle = 0;
  Pose X_WT;
  Vec3 way = Vec3::Zero(), way_turn = Vec3::Zero();
  Bounds4 swept;
};

TEST_F(SweptBounds, HoldWhatIsWithinReachAndOppositeAllAlongTheWay) {
  for (int trial = 0; trial < 20'000; ++trial) {
    roll(0.2, kTurn);
    const Pose X_WT_then = at_part(dice.from_to(0, 1));
    const Quat beside = quaternion_exp(dice.from_to(0, kTurn) * dice.direction()) * X_WT_then.q;
    const Vec3 p_W = beside * place_T() + X_WT_then.p + dice.from_to(0, kReach) * dice.direction();
    const Vec3 opposite_W = -(X_WT_then.q * dice.beside(axis_T, dice.from_to(0, angle + kSlack)));
    ASSERT_TRUE(meets(p_W, opposite_W)) << trial;
    EXPECT_EQ(swept.meeting(alone(at(p_W, opposite_W))), 1u << (4 * kOther + kLane))
        << "a lane that holds nothing";
  }
}

TEST_F(SweptBounds, OfNoWayHoldLittleMore) {
  constexpr double kMargin = 2e-6;  // m, of rounding at 0.3 m from the origin
  for (int trial = 0; trial < 20'000; ++trial) {
    roll(0, 0);
    const Vec3 inside_W = X_WT * place_T();
    const Vec3 opposite_W = -(X_WT.q * axis_T);
    EXPECT_FALSE(meets(inside_W, -(X_WT.q * dice.beside(axis_T, angle + kSlack + 0.01)))) << trial;
    Box3 box_W;
    for (unsigned corner = 0; corner < 8; ++corner)
      box_W.extend(X_WT * box_T.corner(static_cast<Box3::CornerType>(corner)));
    const auto axis = static_cast<Eigen::Index>(trial % 3);
    Vec3 outside_W = inside_W;
    outside_W[axis] = box_W.max()[axis] + kReach + kMargin;
    EXPECT_FALSE(meets(outside_W, opposite_W)) << trial;
    outside_W[axis] = box_W.min()[axis] - kReach - kMargin;
    EXPECT_FALSE(meets(outside_W, opposite_W)) << trial;
  }
}

TEST_F(SweptBounds, OfAllDirectionsStayThat) {
  Bounds4 four;
  four.set(kLane, Bounds::of(Box3(Vec3::Zero(), Vec3::Zero()), NormalCone(Vec3::UnitX(), std::numbers::pi)));
  Sweep still;
  still.reach = kReach;
  still.slack = NormalCone(Vec3::UnitX(), kSlack);
  swept = four.swept(still);
  for (int trial = 0; trial < 100; ++trial) EXPECT_TRUE(meets(Vec3::Zero(), dice.direction()));
}

// Each lane beside each of the other's, by what one box and one cone say of another.
TEST(Bounds4, FourMeetFourWhereOneMeetsOne) {
  Dice dice;
  const auto meets = [](const Bounds& a, const Bounds& b) {
    for (std::size_t i = 0; i < 3; ++i)
      if (a.low[i] > b.high[i] || a.high[i] < b.low[i]) return false;
    const double dot = a.axis[0] * b.axis[0] + a.axis[1] * b.axis[1] + a.axis[2] * b.axis[2];
    return std::acos(std::clamp(-dot, -1.0, 1.0)) <=
           std::atan2(a.sine, a.cosine) + std::atan2(b.sine, b.cosine);
  };
  const auto any = [&] {
    const Vec3 low = dice.in_cube(0.01), size = 0.5 * (dice.in_cube(0.01) + Vec3(0.01, 0.01, 0.01));
    return Bounds::of(Box3(low, low + size), NormalCone(dice.direction(), dice.from_to(0, 1.4)));
  };
  int met = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::array<Bounds, 4> ones, others;
    Bounds4 four, other_four;
    for (unsigned lane = 0; lane < 4; ++lane) {
      four.set(lane, ones[lane] = any());
      other_four.set(lane, others[lane] = any());
    }
    const unsigned meeting = four.meeting(other_four);
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = 0; j < 4; ++j) {
        EXPECT_EQ((meeting >> (4 * j + i) & 1U) != 0, meets(ones[i], others[j])) << trial << ' ' << i << j;
        met += meets(ones[i], others[j]) ? 1 : 0;
      }
  }
  EXPECT_GT(met, 1000);
}

class FeatureTreeTest : public testing::Test {
protected:
  void grow(std::size_t count) {
    features.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 p = dice.in_cube(0.1);
      features.push_back({static_cast<std::uint32_t>(i), Box3(p, p + Vec3(1e-3, 1e-3, 1e-3)),
                          NormalCone(dice.direction(), 0.1)});
    }
    tree = FeatureTree(features);
    seen.assign(count, 0);
    if (!tree.groups().empty()) walk(0, {});
  }
  // `above`: the lanes that lead here.
  void walk(std::uint32_t group, const std::vector<Bounds4>& above) {
    for (unsigned lane = 0; lane < 4; ++lane) {
      const std::uint32_t child = tree.groups()[group].children[lane];
      if (child == FeatureTree::kNone) continue;
      std::vector<Bounds4> path = above;
      path.emplace_back().set(0, tree.groups()[group].bounds[lane]);
      if ((child & FeatureTree::kFeature) == 0) {
        walk(child, path);
        continue;
      }
      const TreeFeature& feature = features.at(child ^ FeatureTree::kFeature);
      ++seen[feature.which];
      for (const Bounds4& bounds : path)
        for (const Vec3& p : {feature.box.min(), feature.box.max()})
          EXPECT_EQ(bounds.meeting(alone(at(p, -dice.beside(feature.cone.axis(), 0.1)))), 1u << 4 * kOther);
    }
  }

  Dice dice;
  std::vector<TreeFeature> features;
  FeatureTree tree;
  std::vector<int> seen;
};

TEST_F(FeatureTreeTest, HasEachFeatureOnceWithinAllBoundsAboveIt) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 4u, 5u, 16u, 17u, 1000u}) {
    grow(count);
    EXPECT_EQ(std::ranges::count(seen, 1), static_cast<std::ptrdiff_t>(count));
  }
}

}  // namespace
}  // namespace fulcrum
