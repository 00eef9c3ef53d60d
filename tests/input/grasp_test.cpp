#include "engine/input/grasp.h"

#include <gtest/gtest.h>

#include "haptics/math/rotation.h"

namespace fulcrum::input {
namespace {

using Hands = std::array<GraspingHand, 2>;

const Pose kHandle{turn_by(0.3, Vec3::UnitY()), Vec3(0.1, 0.2, 0.3)};
const Pose kThere{turn_by(-0.7, Vec3::UnitX()), Vec3(-0.4, 1.0, 0.5)};
const Pose kMoved{turn_by(0.5, Vec3::UnitZ()) * kThere.q, kThere.p + Vec3(0.01, -0.02, 0.03)};

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_LT((a.p - b.p).norm(), 1e-12);
  EXPECT_LT(angle_between(a.q, b.q), 1e-7);
}

Hands right(const std::optional<Pose>& X_WG, bool holds) {
  return {GraspingHand{}, GraspingHand{X_WG, holds}};
}

TEST(Grasp, HandleGoesAsFarAndTurnsAsMuchAsTheHand) {
  Grasp grasp(kHandle);
  expect_same(grasp.follow(right(kThere, true), false), kHandle);  // taken from where it is
  expect_same(grasp.follow(right(kMoved, true), false),
              {turn_by(0.5, Vec3::UnitZ()) * kHandle.q, kHandle.p + Vec3(0.01, -0.02, 0.03)});
}

TEST(Grasp, OpenHandMovesNothing) {
  Grasp grasp(kHandle);
  grasp.follow(right(kThere, false), false);
  expect_same(grasp.follow(right(kMoved, false), false), kHandle);
}

TEST(Grasp, NothingJumpsWhenAHandTakesItElsewhere) {
  Grasp grasp(kHandle);
  grasp.follow(right(kThere, true), false);
  grasp.follow(right(kThere, false), false);
  grasp.follow(right(kMoved, false), false);
  expect_same(grasp.follow(right(kMoved, true), false), kHandle);
}

TEST(Grasp, NothingJumpsWhenAHandIsLostFromSightOrSpaceMoves) {
  Grasp grasp(kHandle);
  grasp.follow(right(kThere, true), false);
  grasp.follow(right(std::nullopt, true), false);
  expect_same(grasp.follow(right(kMoved, true), false), kHandle);
  grasp.let_go();
  expect_same(grasp.follow(right(kThere, true), false), kHandle);
}

TEST(Grasp, IsLostWhileTheHandThatHeldItIsOutOfSight) {
  Grasp grasp(kHandle);
  grasp.follow(right(std::nullopt, true), false);
  EXPECT_FALSE(grasp.is_lost()) << "nobody held it";
  grasp.follow(right(kThere, true), false);
  EXPECT_FALSE(grasp.is_lost());
  for (int i = 0; i < 3; ++i) grasp.follow(right(std::nullopt, true), i > 0);
  EXPECT_TRUE(grasp.is_lost());
  grasp.follow(right(kMoved, false), true);
  EXPECT_FALSE(grasp.is_lost()) << "it is seen again, in a stop, too";
  grasp.follow(right(kThere, true), false);
  grasp.follow(right(std::nullopt, true), false);
  grasp.follow({GraspingHand{kMoved, false}, GraspingHand{}}, false);
  EXPECT_TRUE(grasp.is_lost()) << "another hand is seen, and does not take it";
  grasp.follow({GraspingHand{kMoved, true}, GraspingHand{}}, false);
  EXPECT_FALSE(grasp.is_lost());
}

TEST(Grasp, WhoLetGoIsNotMissed) {
  Grasp grasp(kHandle);
  grasp.follow(right(kThere, true), false);
  grasp.follow(right(std::nullopt, true), false);
  grasp.let_go();
  EXPECT_FALSE(grasp.is_lost());
  grasp.follow(right(std::nullopt, true), false);
  EXPECT_FALSE(grasp.is_lost());
}

TEST(Grasp, StopIsAPause) {
  Grasp grasp(kHandle);
  grasp.follow(right(kThere, true), false);
  expect_same(grasp.follow(right(kMoved, true), true), kHandle);
  expect_same(grasp.follow(right(kMoved, true), false), kHandle);  // from where the hand is now
}

TEST(Grasp, FirstHandKeepsItUntilItLetsGo) {
  Grasp grasp(kHandle);
  grasp.follow(right(kThere, true), false);
  const GraspingHand left{Pose{Quat::Identity(), Vec3(1, 1, 1)}, true};
  expect_same(grasp.follow({left, GraspingHand{kThere, true}}, false), kHandle);
  const GraspingHand moved_left{Pose{Quat::Identity(), Vec3(2, 1, 1)}, true};
  expect_same(grasp.follow({moved_left, GraspingHand{kThere, true}}, false), kHandle);
  grasp.follow({moved_left, GraspingHand{kThere, false}}, false);
  expect_same(grasp.follow({left, GraspingHand{kThere, false}}, false),
              {kHandle.q, kHandle.p - Vec3(1, 0, 0)});
}

}  // namespace
}  // namespace fulcrum::input
