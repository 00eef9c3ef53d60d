// Reference: forces by hand; the same world without guidance; and the limits of the device.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "haptics/effects/guidance/guidance_effect.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/faults.h"
#include "tests/haptics/effects/guided.h"
#include "tests/haptics/effects/handle_springs.h"
#include "tests/haptics/extremes/closed_loop.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

// A free tool, high over the floor; its handle is at the device's middle, and the way goes by.
SceneDesc guided_scene() {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.5);
  desc.contact.response = ContactResponse::constraint;
  desc.coupling = {.stiffness = 200, .angular_stiffness = 0.05};
  desc.device = frictionless_device();
  desc.mapping.X_WD.p = Vec3(0, 0.5, 0);
  desc.guidance = guidance_along({guided_pose(0, {-0.05, 0.5, 0}), guided_pose(2, {0.05, 0.5, 0}, true)});
  return desc;
}

StepResult led_tick(World& world, const Vec3& p_DH, const Command* command = nullptr) {
  return step(world, at({Quat::Identity(), p_DH}), {command, command == nullptr ? 0u : 1u});
}

TEST(GuidanceInAWorld, IsFeltThroughTheMotorsAndToldAsGuided) {
  World world = expect(World::build(guided_scene()));
  EXPECT_FALSE(guided(led_tick(world, {0, 0, 4e-3}).record));
  StepResult result = led_tick(world, {0, 0, 4e-3}, &kGuidanceOn);
  EXPECT_TRUE(guided(result.record));
  for (int i = 0; i < 1500; ++i) result = led_tick(world, {0, 0, 4e-3});
  EXPECT_NEAR((result.command.F_H_D.force - Vec3(0, 0, -0.4)).norm(), 0, 1e-6);
  EXPECT_NEAR(result.record.guidance->force_D.z(), -0.4, 1e-9);
  EXPECT_NEAR((expert_ahead(result.record)->X_WT.p - Vec3(0.025, 0.5, 0)).norm(), 0, 1e-9);
  result = led_tick(world, {0, 0, 4e-3}, &kGuidanceOff);
  EXPECT_TRUE(guided(result.record)) << "it still pulls";
  for (int i = 0; i < 600; ++i) result = led_tick(world, {0, 0, 4e-3});
  EXPECT_FALSE(guided(result.record));
  EXPECT_NEAR(result.command.F_H_D.force.norm(), 0, 1e-6);
}

TEST(GuidanceInAWorld, NamedAndOffNoOtherValueChanges) {
  SceneDesc named = guided_scene(), without = guided_scene();
  without.guidance.reset();
  World a = expect(World::build(named)), b = expect(World::build(without));
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(0.06 * std::sin(i * 5e-3), 0.02 - 1e-5 * i, 0.01 * std::cos(i * 3e-3));
    const StepResult off = led_tick(a, p), bare = led_tick(b, p);
    ASSERT_EQ(off.command.F_H_D.force, bare.command.F_H_D.force) << i;
    ASSERT_EQ(off.record.X_WT.p, bare.record.X_WT.p) << i;
    ASSERT_EQ(off.record.X_WT.q.coeffs(), bare.record.X_WT.q.coeffs()) << i;
    ASSERT_EQ(off.record.energy_port, bare.record.energy_port) << i;
    ASSERT_EQ(off.record.faults, bare.record.faults) << i;
    ASSERT_TRUE(off.record.guidance && !bare.record.guidance);
    ASSERT_FALSE(guided(off.record) || guided(bare.record));
  }
}

// A hand beside the way is led to it, on the device that most scenarios have, with a pull that is chosen for
// it, and comes to rest; the observer sees no more given out than the ramp let in.
TEST(GuidanceInAWorld, AHandComesToRestBesideItsWay) {
  for (const double rate_Hz : {1000.0, 4000.0}) {
    SceneDesc desc = guided_scene();
    desc.tick_s = 1 / rate_Hz;
    desc.device = DeviceDesc{};
    desc.device.handle_weight = 0;
    desc.guidance->stiffness.reset();
    desc.guidance->max_force.reset();
    desc.guidance->gain = 1;
    const Verdict verdict = run_closed_loop(desc, hand_from_to({-0.04, 0.5, 0.02}, {0.02, 0.5, 0.02}, 1), 4);
    EXPECT_TRUE(verdict.at_rest()) << rate_Hz;
    EXPECT_EQ(verdict.faults & kStoppingFaults, 0u);
    EXPECT_LE(verdict.force_max, desc.device.max_force);
    EXPECT_GT(verdict.last.guidance->force_D.norm(), 0.1);
    EXPECT_LT(verdict.last.X_WH.p.z(), 0.02 - 1e-4) << "the hand gives way";
  }
}

// Whatever the handle does and whoever switches: within the device's limits, and no faster than its slew.
TEST(GuidanceInAWorld, StaysWithinTheDevicesLimits) {
  SceneDesc desc = guided_scene();
  desc.guidance->max_force.reset();
  desc.guidance->gain = 1;
  World world = expect(World::build(desc));
  SplitMix random(7);
  Vec3 before = Vec3::Zero(), p = Vec3::Zero();
  const double slew = desc.device.max_force * kTick / 5e-3;
  for (int i = 0; i < 20000; ++i) {
    if (random.uniform() < 0.01)
      p = 0.15 * Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const double values[] = {0, 1, 0.3, -5, 1e300, std::nan("")};
    const Command command{Command::Kind::guidance_gain,
                          values[static_cast<std::size_t>(6 * random.uniform())]};
    const StepResult result = led_tick(world, p, random.uniform() < 0.005 ? &command : nullptr);
    ASSERT_TRUE(result.command.F_H_D.is_finite());
    ASSERT_LE(result.command.F_H_D.force.norm(), desc.device.max_force * (1 + 1e-12));
    ASSERT_LE((result.command.F_H_D.force - before).norm(), slew * (1 + 1e-9)) << i;
    ASSERT_LE(result.record.guidance->force_D.norm(), 0.2 * desc.device.max_force * (1 + 1e-12));
    before = result.command.F_H_D.force;
  }
}

TEST(GuidanceInAWorld, WhoHasNoMotorsIsShownTheWay) {
  SceneDesc desc = guided_scene();
  desc.device.renders_force = false;
  desc.device.kinematics = Kinematics::none;
  World world = expect(World::build(desc));
  led_tick(world, {0, 0, 0.03}, &kGuidanceOn);
  StepResult result;
  for (int i = 0; i < kRampedIn; ++i) result = led_tick(world, {0, 0, 0.03});
  EXPECT_TRUE(result.command.F_H_D.is_zero());
  EXPECT_EQ(result.record.guidance->force_D, Vec3::Zero());
  EXPECT_NEAR(expert_ahead(result.record)->opacity, 1, 1e-9);
  EXPECT_TRUE(std::ranges::any_of(left_out_effects(desc, desc), [](const LeftOut& part) {
    return part.name == "pull" && part.why == "the device 'simulated' has no motors";
  }));
  desc.guidance.reset();
  EXPECT_TRUE(std::ranges::any_of(left_out_effects(desc, desc), [](const LeftOut& part) {
    return part.name == "guidance" && part.why == "the scenario does not name it";
  }));
}

std::string guidance_refusal(const SceneDesc& desc) {
  const Result<World> world = World::build(desc);
  return world ? "" : world.error().sentence;
}

TEST(GuidanceInAWorld, WhatIsNoWayIsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](const auto& change) {
    SceneDesc desc = guided_scene();
    change(*desc.guidance);
    return guidance_refusal(desc);
  };
  EXPECT_EQ(with([](GuidanceDesc&) {}), "");
  EXPECT_NE(with([](GuidanceDesc& g) { g.way.clear(); }).find("no way to lead along"), std::string::npos);
  EXPECT_NE(with([](GuidanceDesc& g) { g.way[1].X_WT.p.y() = nan; }).find("guidance.way"), std::string::npos);
  EXPECT_NE(with([](GuidanceDesc& g) { g.way[0].X_WT.q.w() = nan; }).find("guidance.way"), std::string::npos);
  EXPECT_NE(with([](GuidanceDesc& g) { g.way[1].time = nan; }).find("guidance.way.time"), std::string::npos);
  EXPECT_NE(with([](GuidanceDesc& g) { std::swap(g.way[0], g.way[1]); }).find("back in time"),
            std::string::npos);
  EXPECT_NE(with([](GuidanceDesc& g) { g.dead_band = 0; }).find("guidance.dead_band"), std::string::npos);
  EXPECT_NE(with([](GuidanceDesc& g) { g.max_force = 4.1; }).find("half of what"), std::string::npos);
  const double limit = DampedSpring::limit(frictionless_device(), kTick) / 2;
  EXPECT_NE(with([&](GuidanceDesc& g) { g.stiffness = 1.01 * limit; }).find("lower it"), std::string::npos);
  EXPECT_EQ(with([&](GuidanceDesc& g) { g.stiffness = 0.99 * limit; }), "");
}

TEST(GuidanceInAWorld, TheExpertsRestsAreNoTimeOfItsWay) {
  const std::vector<GuidancePose> way = GuidanceEffect::way_of(
      {{{}, 9, 0.5}, {{Quat::Identity(), Vec3(1, 0, 0)}, 2, 3}, {{Quat::Identity(), Vec3(2, 0, 0)}, 1, 0}});
  ASSERT_EQ(way.size(), 3u);
  EXPECT_EQ(way[0].time, 0);
  EXPECT_EQ(way[1].time, 2);
  EXPECT_EQ(way[2].time, 3);
  EXPECT_TRUE(way[0].rests && way[1].rests && !way[2].rests);
}

}  // namespace
}  // namespace fulcrum::test
