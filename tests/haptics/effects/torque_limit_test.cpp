// The coupling's torque while it is bad, under springs: how deep the tool gets at every turn of the handle,
// and what letting go of the limit does.

#include "haptics/effects/torque_substitution/torque_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/haptics/effects/peg.h"

namespace fulcrum::test {
namespace {

constexpr double kStiffness = 40000;  // N/m, of a region
constexpr double kLever = 10e-3;      // m, between the corners that jam

SceneDesc short_peg(bool limit, ContactResponse response = ContactResponse::penalty) {
  SceneDesc desc = peg_scene({.length = kLever, .response = response, .stiffness = kStiffness});
  desc.torque_substitution->limit_stiffness = limit;
  return desc;
}

// m, the largest depth. The play is taken up gently: an impact goes in by the tool's momentum, good torque or
// bad. Then the handle turns on to `angle` within `seconds` and stays for one.
double deepest(const SceneDesc& desc, double angle, double seconds) {
  World world = expect(World::build(desc));
  const double jammed = 0.06;
  double depth = 0;
  for (int i = 1; i <= 1000; ++i) step(world, at(turned(jammed * i / 1000)), {});
  const auto ticks = static_cast<int>((seconds + 1) / desc.tick_s);
  for (int i = 1; i <= ticks; ++i) {
    const double part = std::min(1.0, i * desc.tick_s / seconds);
    depth = std::max(depth, step(world, at(turned(std::lerp(jammed, angle, part))), {}).record.depth_max);
  }
  return depth;
}

// What the hand's force alone can do, while the torque is good: max_force / stiffness.
double good_bound(const SceneDesc& desc) {
  return desc.coupling.max_force / kStiffness;
}

// Theory: two corners, torque / lever each. With the limit no more than the coupling's largest force, and a
// tenth of it on top in which the tool swings about its balance.
TEST(TorqueLimit, HoldsTheDepthToThatOfTheLargestForceAtEveryTurn) {
  for (const ContactResponse response : {ContactResponse::penalty, ContactResponse::quasi_static}) {
    for (const double degrees : {5.0, 15.0, 45.0, 90.0, 135.0, 180.0}) {
      for (const double seconds : {0.15, 1.0}) {  // half a turn in 0.15 s is faster than a wrist
        const SceneDesc desc = short_peg(true, response);
        EXPECT_LE(deepest(desc, degrees * std::numbers::pi / 180, seconds), 1.12 * good_bound(desc))
            << degrees << " degrees in " << seconds << " s";
      }
    }
  }
}

// Ground truth: d cos t + L sin t = D + 2 F / k, tau = F (L cos t - d sin t).
TEST(TorqueLimit, WithoutItACoupleGoesAsDeepAsStaticsSay) {
  const SceneDesc desc = short_peg(false);
  const double d = PegDesc{}.width, D = PegDesc{}.slot, L = kLever;
  double t = 0, F = 0;
  for (double low = 0, high = 0.5; high - low > 1e-9;) {
    t = 0.5 * (low + high);
    F = 0.5 * kStiffness * (d * std::cos(t) + L * std::sin(t) - D);
    (F * (L * std::cos(t) - d * std::sin(t)) < desc.coupling.max_torque ? low : high) = t;
  }
  const double without = deepest(desc, std::numbers::pi, 1.0);
  EXPECT_NEAR(without, F / kStiffness, 0.03 * without);
  EXPECT_GT(without, 6 * good_bound(desc));
}

// Under the constraint nothing is limited, and nothing needs to be.
TEST(TorqueLimit, TheConstraintNeverDependedOnIt) {
  for (const bool limit : {false, true})
    EXPECT_LT(deepest(short_peg(limit, ContactResponse::constraint), std::numbers::pi, 0.2), 0.02e-3);
}

// Wound up and unwound: the torque comes down without a step, the port never gives energy, and the stiffness
// is whole again.
TEST(TorqueLimit, IsLiftedAsTheHandUnwindsWithoutAJump) {
  World world = expect(World::build(short_peg(true)));
  hold(world, turned(0), 600);  // the force has ramped in, and the port is open
  double last = 0, steepest = 0, least_port = 0, most = 0, stiffness_wound = 0;
  const int turn = 2000;
  TickRecord record;
  for (int i = 1; i <= 3 * turn; ++i) {
    const double there = 0.5 - 0.5 * std::cos(std::numbers::pi * i / turn);  // and back again
    const double part = i <= turn ? there : i <= 2 * turn ? std::lerp(0.02, 1.0, there) : 0.02;
    record = step(world, at(turned(part * 2.0)), {}).record;
    const double torque = record.coupling_F_T_W.torque.norm();
    if (i > turn) steepest = std::max(steepest, std::abs(torque - last));
    last = torque;
    most = std::max(most, torque);
    least_port = std::min(least_port, record.energy_port);
    if (i == turn) stiffness_wound = record.torque_substitution->stiffness;
  }
  const SceneDesc desc = short_peg(true);
  const double k = desc.coupling.angular_stiffness;
  // Rises and falls no faster than the whole spring would.
  EXPECT_LT(steepest, 1.1 * k * 2.0 * (0.5 * std::numbers::pi) / turn);
  EXPECT_NEAR(most, desc.coupling.max_force * kLever, 0.25 * most);
  EXPECT_GE(least_port, kPortBound);
  EXPECT_LT(stiffness_wound, 0.1 * k);
  EXPECT_GT(record.torque_substitution->stiffness, 0.8 * k);
}

TEST(TorqueLimit, FallsAtOnceAndRisesOnlyWhenTheSpringIsBelowIt) {
  TorqueLimit limit(6, 0.01);
  ContactRegion region;
  region.force_W = Vec3(12, 0, 0);
  EXPECT_DOUBLE_EQ(limit.update(true, 0.2, 0.1, {&region, 1}), 0.05);  // lever 1/120 m
  region.force_W = Vec3(3, 0, 0);
  EXPECT_DOUBLE_EQ(limit.update(true, 0.2, 0.1, {&region, 1}), 0.05);
  EXPECT_DOUBLE_EQ(limit.update(false, 0.2, 0, {}), 0.05);
  EXPECT_DOUBLE_EQ(limit.update(false, 0.0501, 0, {}), 0.05);
  EXPECT_EQ(limit.update(false, 0.0499, 0, {}), TorqueLimit::kNone);
  region.force_W = Vec3(1e6, 0, 0);
  EXPECT_DOUBLE_EQ(limit.update(true, 0.2, 0.1, {&region, 1}), 0.01);  // never below the least
}

}  // namespace
}  // namespace fulcrum::test
