// Workspace drift against its law, worked out here axis by axis, and against the exponential by which a hand
// that keeps to a circle comes back to the middle.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/device/simulated_device.h"
#include "haptics/device/workspace_drift.h"
#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

constexpr double kDrift = 0.05;

// A free tool, high over the floor, on a device with exact encoders that stands askew.
SceneDesc drifting_scene(double position_scale = 1, double height = 0.5) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, height);
  desc.coupling = {.stiffness = 200, .angular_stiffness = 0.05};
  desc.device.handle_weight = 0;
  desc.device.encoder_step = desc.device.encoder_step_rad = 0;
  desc.device.workspace = Vec3(0.06, 0.06, 0.06);
  desc.mapping.X_WD = {quaternion_exp(Vec3(0.3, 0.7, -0.2)), Vec3(0.02, height, 0.03)};
  desc.mapping.position_scale = position_scale;
  desc.mapping.drift = kDrift;
  return desc;
}

TEST(WorkspaceDrift, IsAPartOfTheWayAndOfTheWayOut) {
  const Vec3 workspace(0.1, 0.05, 0.2);
  const Vec3 shift = workspace_drift(0.1, {0.04, -0.01, 0.06}, {0, 3e-4, 4e-4}, workspace);
  EXPECT_NEAR((shift - 0.1 * 5e-4 * Vec3(0.4, -0.2, 0.3)).norm(), 0, 1e-18);
  EXPECT_EQ(workspace_drift(0.1, {0.04, -0.01, 0.06}, Vec3::Zero(), workspace), Vec3::Zero());
  EXPECT_EQ(workspace_drift(0.1, Vec3::Zero(), {1e-3, 0, 0}, workspace), Vec3::Zero());
  for (const Vec3& p : {Vec3(0.1, 0.05, 0.2), Vec3(-3, 2, 1), Vec3(0, 0.3, 0)})
    EXPECT_NEAR(workspace_drift(0.1, p, {0, 1e-3, 0}, workspace).norm(), 1e-4, 1e-16);
  EXPECT_EQ(workspace_drift(0.1, {0.01, 0.01, 0}, {1e-3, 0, 0}, {0, 0.1, 0}).x(), 0);
  EXPECT_TRUE(workspace_drift(0.1, {0.01, 0.01, 0}, {1e-3, 0, 0}, {1e-310, 0.1, 0}).allFinite());
}

// How the handle goes round, `off` from the workspace's middle, once in a second; in D.
Vec3 circle(double off, double radius, double t) {
  const double a = 2 * std::numbers::pi * t;
  return {off + radius * std::cos(a), radius * std::sin(a), 0};
}

// The hand keeps the tool on a circle in the scene, by what it sees: it holds back by what has drifted.
struct Kept {
  std::vector<Vec3> p_DH;  // m
  std::vector<TickRecord> records;
};
Kept keep_on_circle(const SceneDesc& desc, double off, double radius, double seconds) {
  World world = expect(World::build(desc));
  const MappingDesc& mapping = desc.mapping;
  Kept kept;
  Vec3 drifted_W = Vec3::Zero();
  for (int i = 0; i < seconds / desc.tick_s; ++i) {
    const Vec3 wanted_W = mapping.handle_in_world({Quat::Identity(), circle(off, radius, i * desc.tick_s)}).p;
    const Pose X_DH = mapping.handle_in_device({mapping.X_WD.q, wanted_W - drifted_W});
    kept.p_DH.push_back(X_DH.p);
    kept.records.push_back(step(world, at(X_DH), {}).record);
    drifted_W = *kept.records.back().drifted_W;
  }
  return kept;
}

TEST(DriftInAWorld, BringsTheHandBackByTheExponentialOfItsWay) {
  for (const double scale : {1.0, 2.5}) {
    const Kept kept = keep_on_circle(drifting_scene(scale), 0.04, 0.01, 40);
    const auto middle_of_round = [&](int second) {
      Vec3 sum = Vec3::Zero();
      for (int i = 0; i < 1000; ++i) sum += kept.p_DH[static_cast<std::size_t>(1000 * second + i)];
      return Vec3(sum / 1000);
    };
    const double first = middle_of_round(0).x();
    double way = 0;  // from the middle of the first round to that of each
    for (int second = 0; second < 39; ++second) {
      const double expected = first * std::exp(-kDrift * way / 0.06);
      EXPECT_NEAR(middle_of_round(second).x(), expected, 0.02 * first) << scale << ", " << second;
      for (int i = 500; i < 1500; ++i) {
        const auto k = static_cast<std::size_t>(1000 * second + i);
        way += (kept.p_DH[k] - kept.p_DH[k - 1]).norm();
      }
    }
    EXPECT_LT(middle_of_round(39).x(), 0.15 * first);
  }
}

// The law, one axis after the other, from the handle's places alone.
TEST(DriftInAWorld, GoesByItsLawInEveryTick) {
  const SceneDesc desc = drifting_scene(2.5);
  const Kept kept = keep_on_circle(desc, 0.055, 0.02, 3);
  const Mat3 R_WD = desc.mapping.X_WD.q.toRotationMatrix();
  std::array<double, 3> drifted_D{};
  for (std::size_t k = 1; k < kept.p_DH.size(); ++k) {
    const Vec3& p = kept.p_DH[k];
    const Vec3 dp = p - kept.p_DH[k - 1];
    const double way = std::hypot(dp.x(), dp.y(), dp.z());
    const double out = std::hypot(p.x(), p.y(), p.z()) / 0.06;
    for (std::size_t axis = 0; axis < 3; ++axis)
      drifted_D[axis] += kDrift * way * p[static_cast<Eigen::Index>(axis)] / 0.06 / std::max(1.0, out);
    const Vec3 expected_W = 2.5 * R_WD * Vec3(drifted_D[0], drifted_D[1], drifted_D[2]);
    const Vec3 drifted_W = *kept.records[k].drifted_W;
    ASSERT_NEAR((drifted_W - expected_W).norm(), 0, 1e-12) << k;
    const Vec3 shift_W = drifted_W - *kept.records[k - 1].drifted_W;
    ASSERT_LE(shift_W.norm(), kDrift * 2.5 * way + 1e-15) << k;
    // The handle in the scene is where it would be, and so much farther.
    const Vec3 bare_W = desc.mapping.handle_in_world({Quat::Identity(), p}).p;
    ASSERT_NEAR((kept.records[k].X_WH.p - bare_W - drifted_W).norm(), 0, 1e-12) << k;
  }
}

TEST(DriftInAWorld, RestsWithTheHandle) {
  World world = expect(World::build(drifting_scene()));
  step(world, at({Quat::Identity(), Vec3(0.03, 0, 0)}), {});
  const Vec3 moved = *step(world, at({Quat::Identity(), Vec3(0.04, 0, 0)}), {}).record.drifted_W;
  EXPECT_GT(moved.norm(), 0);
  for (int i = 0; i < 2000; ++i) {  // a turn is no way
    const Quat turn = quaternion_exp(Vec3(0, 0, 1e-3 * i));
    ASSERT_EQ(*step(world, at({turn, Vec3(0.04, 0, 0)}), {}).record.drifted_W, moved);
  }
}

Vec3 drifted_after(World& world, const Vec3& p_DH) {
  return *step(world, at({Quat::Identity(), p_DH}), {}).record.drifted_W;
}

// A device's error is no way of a hand's; the way goes on from where the handle is found.
TEST(DriftInAWorld, AJumpIsNoWay) {
  World world = expect(World::build(drifting_scene()));
  drifted_after(world, {-0.05, 0, 0});
  const Vec3 moved = drifted_after(world, {-0.04, 0, 0});
  EXPECT_GT(moved.norm(), 0);
  EXPECT_EQ(drifted_after(world, {0.06, 0, 0}), moved);
  EXPECT_NEAR((drifted_after(world, {0.05, 0, 0}) - moved).norm(), kDrift * 0.01 * 0.05 / 0.06, 1e-12);
}

TEST(DriftInAWorld, WhatLiesBetweenSamplesThatAreLostIsNoWay) {
  for (const bool finite : {true, false}) {
    World world = expect(World::build(drifting_scene()));
    drifted_after(world, {0.03, 0, 0});
    const Vec3 moved = drifted_after(world, {0.04, 0, 0});
    DeviceSample lost = at({Quat::Identity(), Vec3(0.04, finite ? 0 : std::nan(""), 0)});
    lost.connected = !finite;
    EXPECT_EQ(*step(world, lost, {}).record.drifted_W, moved);
    EXPECT_EQ(drifted_after(world, {0.05, 0, 0}), moved);
    EXPECT_GT((drifted_after(world, {0.055, 0, 0}) - moved).norm(), 0);
  }
}

TEST(DriftInAWorld, ACountThatTogglesIsNoWay) {
  SceneDesc desc = drifting_scene();
  desc.device.encoder_step = 5e-5;
  World world = expect(World::build(desc));
  const Vec3 rest(0.05, 0.01, 0);
  drifted_after(world, {0.04, 0.01, 0});
  const Vec3 moved = drifted_after(world, rest);
  EXPECT_GT(moved.norm(), 0);
  for (int i = 0; i < 2000; ++i)
    ASSERT_EQ(drifted_after(world, rest + Vec3(i % 2 == 0 ? 5e-5 : 0, 0, i % 3 == 0 ? 5e-5 : 0)), moved) << i;
  // What goes on is a way, however slowly it goes.
  for (int i = 1; i <= 20; ++i) drifted_after(world, rest + Vec3(i * 5e-5, 0, 0));
  EXPECT_GT((drifted_after(world, rest + Vec3(21 * 5e-5, 0, 0)) - moved).norm(), 0.9 * kDrift * 1e-3 * 0.8);
}

TEST(DriftInAWorld, RestsInContactAndWhileTheClutchIsPressed) {
  SceneDesc desc = drifting_scene(1, 0.05);
  desc.mapping.clutch_button = 0;
  World world = expect(World::build(desc));
  int touched = 0, clutched = 0, free = 0;
  TickRecord before;
  for (int i = 0; i < 6000; ++i) {
    const double t = i * desc.tick_s;
    const Vec3 p_W(0.03 + 0.01 * std::sin(9 * t), 0.02 * std::cos(3 * t), 0.01 * std::cos(9 * t));
    DeviceSample sample = at(desc.mapping.handle_in_device({Quat::Identity(), p_W}));
    sample.buttons = i / 700 % 3 == 2 ? 1 : 0;
    const TickRecord record = step(world, sample, {}).record;
    if (i > 0) {
      const bool moved = *record.drifted_W != *before.drifted_W;
      const bool may = before.regions == 0 && !record.clutched && !before.clutched;
      ASSERT_EQ(moved, may) << i;
      touched += before.regions > 0 ? 1 : 0;
      clutched += record.clutched ? 1 : 0;
      free += may ? 1 : 0;
    }
    before = record;
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(clutched, 1000);
  EXPECT_GT(free, 400);
}

// The port is the hand's work at the device, which drift does nothing to. Weight: what the hand lifts it
// with, it gets back, and of what drift has lifted it gets nothing.
TEST(DriftInAWorld, ThePortIsTheHandsOwnWork) {
  for (const bool weight : {false, true}) {
    SceneDesc desc = drifting_scene(2.5);
    desc.tool.weight = weight;
    desc.mapping.drift = 0.3;
    World world = expect(World::build(desc));
    double truth = 0, opened = 0, work = 0, lifted = 0, tool_before = 0;
    bool open = false;
    Vec3 told = Vec3::Zero(), before = Vec3::Zero();
    const double pull = weight ? 0.2 * 9.80665 : 0.0;
    for (int i = 0; i < 5000; ++i) {
      const double t = i * desc.tick_s;
      const Vec3 p(0.02 + 0.02 * std::sin(9 * t), 0.03 + 0.02 * std::cos(8 * t), 0.01 * std::sin(7 * t));
      const StepResult result = step(world, at({Quat::Identity(), p}), {});
      const TickRecord& record = result.record;
      ASSERT_EQ(record.regions, 0);
      const double height = tool_before - record.drifted_W->y();  // of the tool, when it was pulled
      if (open) {
        truth -= told.dot(p - before) + pull * (height - lifted) / 2.5;
        work += std::abs(told.dot(p - before));
        ASSERT_NEAR(record.energy_port - opened, truth, 1e-9) << i << ", " << weight;
      } else {
        opened = record.energy_port;
        open = record.force_gain >= 1;
      }
      told = result.command.F_H_D.force;
      tool_before = record.X_WT.p.y();
      lifted = height;
      before = p;
    }
    EXPECT_GT(work, 1e-3);
  }
}

// Without a mass no force is made up for on the way: nothing is made by drifting, and nothing taken back.
TEST(DriftInAWorld, AToolWithoutMassMakesNoEnergyByIt) {
  SceneDesc desc = drifting_scene();
  desc.contact.response = ContactResponse::constraint;
  desc.mapping.drift = MappingDesc::kMostDrift;
  for (const TickRecord& record : keep_on_circle(desc, 0.04, 0.01, 10).records) {
    ASSERT_EQ(record.faults & (kEnergyBound | kPassivityControl | kStoppingFaults), 0u);
    ASSERT_GT(record.energy_port, kPortBound);
  }
}

TEST(DriftInAWorld, ComesOutTheSameAgain) {
  const SceneDesc desc = drifting_scene(2.5);
  const Kept first = keep_on_circle(desc, 0.04, 0.01, 3);
  World again = expect(World::build(desc));
  for (std::size_t k = 0; k < first.p_DH.size(); ++k) {
    const TickRecord& then = first.records[k];
    const TickRecord now = step(again, at({Quat::Identity(), first.p_DH[k]}), {}).record;
    ASSERT_EQ(*now.drifted_W, *then.drifted_W) << k;
    ASSERT_EQ(now.X_WH.p, then.X_WH.p) << k;
    ASSERT_EQ(now.X_WT.p, then.X_WT.p) << k;
    ASSERT_EQ(now.device_F_H_D.force, then.device_F_H_D.force) << k;
    ASSERT_EQ(now.energy_port, then.energy_port) << k;
  }
}

// A simulated hand sees the tool: with drift it holds the tool on the same path, and its handle nearer to the
// middle.
TEST(DriftInAWorld, ASimulatedHandKeepsTheToolOnItsPath) {
  std::vector<Waypoint> corners;
  for (int i = 0; i < 24; ++i)
    corners.push_back(
        {{Quat::Identity(), {0.03 + (i % 4 < 2 ? 0.01 : -0.01), 0.5, i % 4 % 3 ? 0.01 : -0.01}}, 0.5, 0.1});
  struct Run {
    double off = 0;    // m, of the handle from the middle, over the last second
    double error = 0;  // m, of the tool from its path, in the worst tick
  };
  const auto run = [&](double drift) {
    SceneDesc desc = drifting_scene();
    desc.contact.response = ContactResponse::constraint;
    desc.mapping.X_WD = {Quat::Identity(), Vec3(0, 0.5, 0)};
    desc.mapping.drift = drift;
    HandTask task{.path = HandPath(corners), .hand = {}, .X_HT = {}, .mapping = desc.mapping};
    task.hand.tremor = task.hand.tremor_rad = 0;
    SimulatedDevice device({.device = desc.device, .tick_s = desc.tick_s}, task);
    World world = expect(World::build(desc));
    Run result;
    constexpr int ticks = 14000;
    for (int i = 0; i < ticks; ++i) {
      const StepResult tick = step(world, device.read(), {});
      device.write(tick.command);
      const Vec3 wanted = task.path.at(i * desc.tick_s).p;
      result.error = std::max(result.error, (tick.record.X_WT.p - wanted).norm());
      if (i >= ticks - 1000) result.off += device.X_DH().p.norm() / 1000;
    }
    return result;
  };
  const Run with = run(0.1), without = run(0);
  EXPECT_LT(with.error, without.error + 0.2e-3);
  EXPECT_LT(with.off, 0.75 * without.off);
}

TEST(DriftInAWorld, WithoutItThereIsNoColumnAndNoPart) {
  SceneDesc desc = drifting_scene();
  EXPECT_EQ(std::ranges::count(part_names(desc), "workspace drift"), 1);
  desc.mapping.drift = 0;
  EXPECT_EQ(std::ranges::count(part_names(desc), "workspace drift"), 0);
  EXPECT_FALSE(expect(World::build(desc)).blank_record().drifted_W);
  desc.mapping.drift = 0.51;
  const Result<World> world = World::build(desc);
  ASSERT_FALSE(world);
  EXPECT_EQ(world.error().sentence, "device.drift is 0.51; it must be from 0 to 0.5.");
}

}  // namespace
}  // namespace fulcrum::test
