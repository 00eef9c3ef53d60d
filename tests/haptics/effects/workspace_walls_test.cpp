// Reference: depth times stiffness, by hand; the work over ways, by sums; and the border of stability by a
// mass that is integrated here, under a force that is held from tick to tick.

#include "haptics/effects/workspace_walls/workspace_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"
#include "tests/haptics/effects/handle_springs.h"
#include "tests/haptics/extremes/closed_loop.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

const Vec3 kStill = Vec3::Zero();

// 4 N for the walls, which begin at 70, 50 and 40 mm with a margin of 10 mm.
DeviceDesc round_device() {
  DeviceDesc device = frictionless_device();
  device.workspace = Vec3(0.08, 0.06, 0.05);
  return device;
}

WorkspaceWalls walls_of(double stiffness, const DeviceDesc& device = round_device()) {
  return WorkspaceWalls({.margin = 0.01, .stiffness = stiffness}, device, kTick);
}

TEST(WorkspaceWalls, PushByDepthTimesStiffness) {
  WorkspaceWalls walls = walls_of(300);
  EXPECT_NEAR((walls.process({0.075, 0.01, -0.03}, kStill) - Vec3(-1.5, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(walls.record().depth, 0.005, 1e-15);
  EXPECT_NEAR((walls.process({0, -0.052, 0}, kStill) - Vec3(0, 0.6, 0)).norm(), 0, 1e-12);
  // Beyond an edge and a corner, towards the nearest point of the box: lengths 5 = |3, 4| and 9 = |4, 4, 7|.
  EXPECT_NEAR((walls.process({0.073, 0, -0.044}, kStill) - 300e-3 * Vec3(-3, 0, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR((walls.process({-0.074, 0.054, 0.047}, kStill) - 300e-3 * Vec3(4, -4, -7)).norm(), 0, 1e-12);
  EXPECT_NEAR(walls.record().depth, 0.009, 1e-15);
}

TEST(WorkspaceWalls, NothingIsFeltWithin) {
  WorkspaceWalls walls = walls_of(300);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.0699, -0.0499, 0.0399), Vec3(-0.0699, 0.02, 0.01)}) {
    EXPECT_EQ(walls.process(p, {1e-3, 1e-3, -1e-3}), Vec3::Zero());
    EXPECT_EQ(walls.record().depth, 0);
    EXPECT_EQ(walls.stored(), 0);
  }
}

TEST(WorkspaceWalls, TheForceIsBoundedAtHalfTheDevices) {
  WorkspaceWalls walls = walls_of(1000);
  EXPECT_NEAR(walls.process({0.0739, 0, 0}, kStill).x(), -3.9, 1e-12);
  EXPECT_NEAR(walls.process({0.2, 0, 0}, kStill).x(), -4, 1e-12);
  EXPECT_NEAR(walls.process({0.2, 0.3, -0.4}, kStill).norm(), 4, 1e-12);
  EXPECT_NEAR(walls.process({0.0701, 0, 0}, {1, 0, 0}).norm(), 4, 1e-12);
}

// B = 2 zeta sqrt(K m) of 0.1 kg: 4 N s/m at 160 N/m. The low-pass settles on the velocity.
TEST(WorkspaceWalls, ADamperTakesOnTheWayInAndNeverPulls) {
  WorkspaceWalls walls = walls_of(160);
  EXPECT_NEAR(walls.damping(), 4, 1e-12);
  double x = 0.05;
  for (; x < 0.074; x += 50e-6) walls.process({x, 0, 0}, {50e-6, 0, 0});
  EXPECT_NEAR(walls.process({0.074, 0, 0}, {50e-6, 0, 0}).x(), -(160 * 0.004 + 4 * 0.05), 1e-9);
  for (; x > 0.0701; x -= 0.4e-3) EXPECT_LE(walls.process({x, 0, 0}, {-0.4e-3, 0, 0}).x(), 0) << x;
  EXPECT_EQ(walls.process({0.0702, 0, 0}, {-0.4e-3, 0, 0}).x(), 0);
}

// Where a hand goes round through walls, edges, corners and the force's bound; from 0 to 1 and back.
Vec3 round_trip(double t) {
  const double a = 2 * std::numbers::pi * t;
  return {0.085 * std::sin(a), 0.06 * std::sin(2 * a + 0.4), 0.055 * std::cos(3 * a)};
}

// J, that the springs take of a hand between two places of that way; their force at the middle of each step.
double taken(WorkspaceWalls& walls, double from, double to) {
  constexpr int steps = 100000;
  double J = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = from + (to - from) * i / steps, next = from + (to - from) * (i + 1) / steps;
    J -= walls.process((round_trip(t) + round_trip(next)) / 2, kStill).dot(round_trip(next) - round_trip(t));
  }
  return J;
}

TEST(WorkspaceWalls, SpringsGiveBackWhatTheyTookAndHoldItMeanwhile) {
  WorkspaceWalls walls = walls_of(500);
  double most = 0;
  for (const double until : {0.1, 0.22, 0.25, 0.31, 0.6, 0.83}) {
    const double before = [&] {
      walls.process(round_trip(0), kStill);
      return walls.stored();
    }();
    const double J = taken(walls, 0, until);
    walls.process(round_trip(until), kStill);
    EXPECT_NEAR(walls.stored() - before, J, 1e-8) << until;
    most = std::max(most, J);
  }
  EXPECT_GT(most, 0.01);
  EXPECT_NEAR(taken(walls, 0, 1), 0, 1e-8);
}

TEST(WorkspaceWalls, ARoundTripCostsWhateverItsSpeed) {
  for (const double seconds : {0.3, 1.0, 10.0}) {
    WorkspaceWalls walls = walls_of(500);
    double J = 0;
    Vec3 before = round_trip(0), force = walls.process(before, kStill);
    const int ticks = static_cast<int>(seconds / kTick);
    for (int i = 1; i <= ticks; ++i) {  // the force is held over the tick
      const Vec3 p = round_trip(static_cast<double>(i) / ticks);
      J -= force.dot(p - before);
      force = walls.process(p, p - before);
      before = p;
    }
    EXPECT_GT(J, 1e-4) << seconds;
  }
}

// m, pressed on a wall by 1 N.
double late_swing(const DeviceDesc& device, double stiffness, std::size_t late) {
  WorkspaceWalls walls = walls_of(stiffness, device);
  return swing_left(device, {.rest = 0.07 + 1 / stiffness, .press = 1}, late, [&](double x, double per_tick) {
    return walls.process({x, 0, 0}, {per_tick, 0, 0}).x();
  });
}

TEST(WorkspaceWalls, AreStableUpToTheLimitAndNoFurther) {
  for (const double mass : {0.05, 0.1, 0.3}) {
    for (const bool late : {false, true}) {
      DeviceDesc device = round_device();
      device.handle_mass = mass;
      if (late) device.sample_rate_Hz = 1000;
      const double limit = DampedSpring::limit(device, kTick);
      ASSERT_GT(limit, 300) << mass;
      EXPECT_LT(late_swing(device, 0.9 * limit, late ? 1 : 0), 0.5e-6) << mass << late;
      EXPECT_GT(late_swing(device, 1.1 * limit, late ? 1 : 0), 2e-6) << mass << late;
    }
  }
}

TEST(WorkspaceWalls, TheStiffnessSuitsTheDevice) {
  const auto chosen = [](const DeviceDesc& device, double margin) {
    return WorkspaceWalls({.margin = margin}, device, kTick).stiffness();
  };
  const DeviceDesc device = round_device();
  EXPECT_NEAR(chosen(device, 0.02), 4 / 0.02, 1e-9);  // the whole 4 N at the workspace's end
  const double limit = DampedSpring::limit(device, kTick);
  EXPECT_NEAR(chosen(device, 1e-4), 0.25 * limit, 1e-9 * limit);
  DeviceDesc coarse = device;
  coarse.friction = 0.01;
  coarse.encoder_step = 200e-6;
  EXPECT_NEAR(chosen(coarse, 0.02), 2 * 0.01 / 200e-6, 1e-9);
  EXPECT_EQ(WorkspaceWalls::margin({}, device), 0.2 * 0.05);
}

// A free tool, high over the floor; its handle is at the device's middle.
SceneDesc walled_scene() {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.5);
  desc.contact.response = ContactResponse::constraint;
  desc.coupling = {.stiffness = 200, .angular_stiffness = 0.05};
  desc.device = round_device();
  desc.mapping.X_WD.p = Vec3(0, 0.5, 0);
  desc.workspace_walls = WorkspaceWallsDesc{.margin = 0.01, .stiffness = 300};
  return desc;
}

DeviceSample handle_at(const Vec3& p, bool clutch = false) {
  DeviceSample sample = at({Quat::Identity(), p});
  sample.buttons = clutch ? 1 : 0;
  return sample;
}

TEST(WorkspaceWallsInAWorld, ArePushedThroughTheMotors) {
  World world = expect(World::build(walled_scene()));
  const StepResult result = hold(world, {Quat::Identity(), Vec3(0.076, 0, 0)}, 1500);
  EXPECT_NEAR((result.command.F_H_D.force - Vec3(-1.8, 0, 0)).norm(), 0, 1e-6);
  ASSERT_TRUE(result.record.workspace_walls);
  EXPECT_NEAR(result.record.workspace_walls->depth, 0.006, 1e-12);
  EXPECT_NEAR(result.record.workspace_walls->force_D.x(), -1.8, 1e-9);
}

// The walls are the device's, wherever it stands and whatever a metre of it is in the scene.
TEST(WorkspaceWallsInAWorld, AreOfTheDeviceWhateverTheMapping) {
  SceneDesc desc = walled_scene();
  desc.mapping.X_WD.q = quaternion_exp(Vec3(0.4, -1.1, 0.3));
  desc.mapping.position_scale = 2.5;
  desc.mapping.force_scale = 3;
  World world = expect(World::build(desc));
  const StepResult result = hold(world, {Quat::Identity(), Vec3(0, -0.055, 0)}, 3000);
  EXPECT_NEAR((result.command.F_H_D.force - Vec3(0, 1.5, 0)).norm(), 0, 1e-6);
}

// With the clutch pressed the walls push on, and the port is the work at the device all along.
TEST(WorkspaceWallsInAWorld, StayWhileTheClutchIsPressedAndAreCounted) {
  SceneDesc desc = walled_scene();
  desc.mapping.clutch_button = 0;
  World world = expect(World::build(desc));
  double truth = 0, opened = 0, pushed = 0, least = 0;
  bool open = false;
  Vec3 told = Vec3::Zero(), before = Vec3::Zero();
  for (int i = 0; i < 8000; ++i) {
    const bool clutch = i / 500 % 2 == 1;
    const Vec3 p(0.075 * std::sin(i * 4e-3), 0.05 * std::sin(i * 7e-3), 0);
    const StepResult result = step(world, handle_at(p, clutch), {});
    const TickRecord& record = result.record;
    if (open) {
      truth -= told.dot(p - before);
      ASSERT_NEAR(record.energy_port - opened, truth, 1e-9) << i;
      if (clutch) pushed = std::max(pushed, told.norm());
      least = std::min(least, record.energy_port);
    } else {
      opened = record.energy_port;
      open = record.force_gain >= 1;
    }
    told = result.command.F_H_D.force;
    EXPECT_EQ(record.faults & (kEnergyBound | kStoppingFaults), 0u);
    before = p;
  }
  EXPECT_GT(pushed, 1);
  EXPECT_GT(truth, 0.01);
  EXPECT_GT(least, kPortBound);
}

TEST(WorkspaceWallsInAWorld, WithinThemNoOtherValueChanges) {
  SceneDesc desc = walled_scene(), without = walled_scene();
  desc.mapping.X_WD.p = without.mapping.X_WD.p = Vec3::Zero();
  without.workspace_walls.reset();
  World a = expect(World::build(desc)), b = expect(World::build(without));
  for (int i = 0; i < 2000; ++i) {
    const DeviceSample sample = handle_at({0.06 * std::sin(i * 5e-3), 0.02 - 1e-5 * i, 0});
    const StepResult walled = step(a, sample, {}), bare = step(b, sample, {});
    ASSERT_EQ(walled.command.F_H_D.force, bare.command.F_H_D.force) << i;
    ASSERT_EQ(walled.record.X_WT.p, bare.record.X_WT.p) << i;
    ASSERT_EQ(walled.record.X_WT.q.coeffs(), bare.record.X_WT.q.coeffs()) << i;
    ASSERT_EQ(walled.record.energy_port, bare.record.energy_port) << i;
    ASSERT_EQ(walled.record.faults, bare.record.faults) << i;
    ASSERT_TRUE(walled.record.workspace_walls && !bare.record.workspace_walls);
  }
}

// A hand that wants to go through them, on the device that most scenarios have: it comes to rest, and no
// energy is made.
TEST(WorkspaceWallsInAWorld, AHandComesToRestInThem) {
  for (const double speed : {0.1, 0.8}) {
    SceneDesc desc = walled_scene();
    desc.device = DeviceDesc{};
    desc.device.handle_weight = 0;
    desc.workspace_walls = WorkspaceWallsDesc{};
    const HandTask hand = hand_from_to({0, 0.5, 0}, {0.1, 0.5, 0}, 0.1 / speed);
    const Verdict verdict = run_closed_loop(desc, hand, 4);
    EXPECT_TRUE(verdict.at_rest()) << speed;
    EXPECT_EQ(verdict.faults & (kEnergyBound | kStoppingFaults), 0u) << speed;
    EXPECT_LE(verdict.force_max, desc.device.max_force);
    EXPECT_GT(verdict.last.workspace_walls->depth, 0.005);
  }
}

// N: the largest force of the motors, and its largest step from tick to tick, while the handle rests at `p`
// where it has jumped to.
struct Answer {
  double force = 0, step = 0;
};
Answer answer_at(World& world, const Vec3& p, Vec3 before) {
  Answer answer;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 told = step(world, handle_at(p), {}).command.F_H_D.force;
    answer.force = std::max(answer.force, told.norm());
    answer.step = std::max(answer.step, (told - before).norm());
    before = told;
  }
  return answer;
}

// Half a millimetre deep in a wall after a jump of 70.5 mm, out of nothing and back in from the other side:
// its spring pushes with 0.15 N, and its damper takes the jump for no speed.
TEST(WorkspaceWallsInAWorld, AJumpIsNoSpeedForTheDamper) {
  SceneDesc desc = walled_scene();
  const double slew = desc.device.max_force * kTick / 5e-3;
  World world = expect(World::build(desc));
  const Vec3 right(0.0705, 0, 0), left(-0.0705, 0, 0);
  Vec3 last = hold(world, {Quat::Identity(), Vec3::Zero()}, 1000).command.F_H_D.force;
  for (const Vec3& p : {right, left, right}) {
    const Answer answer = answer_at(world, p, last);
    EXPECT_LT(answer.force, 0.16);
    EXPECT_LT(answer.step, slew);
    last = step(world, handle_at(p), {}).command.F_H_D.force;
    EXPECT_NEAR(last.norm(), 0.15, 1e-6);
  }
}

// The same where the device was lost meanwhile, by a way that a hand could have gone in a tick.
TEST(WorkspaceWallsInAWorld, WhatAHandHasGoneUnseenIsNoSpeedForTheDamper) {
  SceneDesc desc = walled_scene();
  World world = expect(World::build(desc));
  hold(world, {Quat::Identity(), Vec3(0.06, 0, 0)}, 1000);
  DeviceSample lost = handle_at({0.06, 0, 0});
  lost.connected = false;
  for (int i = 0; i < 10; ++i) step(world, lost, {});
  const Command acknowledge{Command::Kind::acknowledge};
  step(world, handle_at({0.0705, 0, 0}), {&acknowledge, 1});
  EXPECT_NEAR(step(world, handle_at({0.0705, 0, 0}), {}).record.workspace_walls->force_D.norm(), 0.15, 1e-9);
  EXPECT_LT(answer_at(world, {0.0705, 0, 0}, Vec3::Zero()).force, 0.16);
}

TEST(WorkspaceWallsInAWorld, ADeviceThatDoesNotPushHasNone) {
  SceneDesc desc = walled_scene();
  desc.device.renders_force = false;
  desc.device.kinematics = Kinematics::none;
  World world = expect(World::build(desc));
  EXPECT_FALSE(world.blank_record().workspace_walls);
  const std::vector<LeftOut> left_out = left_out_effects(desc, desc);
  EXPECT_TRUE(std::ranges::any_of(left_out, [](const LeftOut& part) {
    return part.name == "workspace walls" && part.why == "the device 'simulated' has no motors";
  }));
}

std::string refusal(const SceneDesc& desc) {
  const Result<World> world = World::build(desc);
  return world ? "" : world.error().sentence;
}

TEST(WorkspaceWallsInAWorld, WhatCannotStandIsRefused) {
  SceneDesc desc = walled_scene();
  desc.workspace_walls->margin = 0.05;
  EXPECT_EQ(refusal(desc),
            "device.workspace_walls.margin is 50 mm, and the workspace of the device 'simulated' reaches 50 "
            "mm from its middle: make it smaller.");
  desc = walled_scene();
  const double limit = DampedSpring::limit(desc.device, desc.tick_s) / 2;
  desc.workspace_walls->stiffness = 1.01 * limit;
  EXPECT_NE(refusal(desc).find("N/m at a tick of 1 ms: lower it"), std::string::npos) << refusal(desc);
  desc.workspace_walls->stiffness = 0.99 * limit;
  EXPECT_EQ(refusal(desc), "");
  desc.device.workspace = Vec3(0.08, 0, 0.05);
  EXPECT_NE(refusal(desc).find("has no size"), std::string::npos) << refusal(desc);
  desc = walled_scene();
  desc.workspace_walls->margin = std::nan("");
  EXPECT_NE(refusal(desc).find("device.workspace_walls.margin"), std::string::npos) << refusal(desc);
}

}  // namespace
}  // namespace fulcrum::test
