// Vibrotactile motion in a World: a point that is swept over the floor by a handle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "haptics/device/simulated_device.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/world/knocks.h"

namespace fulcrum::test {
namespace {

DeviceDesc fingertip(bool pushes) {
  DeviceDesc device;
  device.renders_force = pushes;
  device.kinematics = pushes ? Kinematics::cartesian : Kinematics::none;
  device.handle_weight = 0;
  const ChannelDesc coil{.name = "left", .largest = 12.84, .resonance_Hz = 233, .quality = 3};
  device.vibrotactile = VibrotactileDesc{{coil, coil}};
  device.vibrotactile->channels[1].name = "right";
  return device;
}

SceneDesc finger_scene(bool pushes = true) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, -0.2e-3);
  desc.contact.response = ContactResponse::constraint;
  desc.device = fingertip(pushes);
  desc.vibrotactile_motion.emplace();
  return desc;
}

// Held at x = -20 mm until the force is there, then to 20 mm and back at `speed`, `height` above the floor.
std::vector<TickRecord> swept(const SceneDesc& desc, double speed = 0.1, double height = -0.2e-3,
                              const std::vector<std::pair<int, Command>>& commands = {}) {
  World world = expect(World::build(desc));
  std::vector<TickRecord> records;
  const auto go = [&](double x) {
    std::vector<Command> due;
    for (const auto& [tick, command] : commands)
      if (tick == static_cast<int>(records.size())) due.push_back(command);
    const Pose X_WH{Quat::Identity(), Vec3(x, height, 0)};
    records.push_back(step(world, at(desc.mapping.handle_in_device(X_WH)), due).record);
  };
  for (int i = 0; i < 600; ++i) go(-0.02);
  const int ticks = static_cast<int>(0.04 / speed / desc.tick_s);
  for (int i = 0; i < ticks; ++i) go(-0.02 + i * speed * desc.tick_s);
  for (int i = ticks; i > 0; --i) go(-0.02 + i * speed * desc.tick_s);
  return records;
}

double told(const TickRecord& record) {
  return record.vibrotactile_motion->command.level[0] + record.vibrotactile_motion->command.level[1];
}

TEST(VibrotactileInAWorld, ThereInTheWindowOfEitherWayAndOnlyThere) {
  for (const bool pushes : {true, false}) {
    int right = 0, left = 0;
    for (const TickRecord& record : swept(finger_scene(pushes))) {
      const VibrotactileRecord& cues = *record.vibrotactile_motion;
      EXPECT_NEAR(cues.x, record.X_WH.p.x(), 1e-12);
      const bool inside =
          cues.direction != 0 && cues.direction * cues.x >= 0 && cues.direction * cues.x <= 0.01;
      EXPECT_EQ(told(record) > 0, inside) << record.tick;
      (cues.direction > 0 ? right : left) += inside;
    }
    EXPECT_NEAR(right, 100, 1);
    EXPECT_NEAR(left, 100, 1);
  }
}

TEST(VibrotactileInAWorld, NothingWithoutTouch) {
  for (const TickRecord& record : swept(finger_scene(), 0.1, 1e-3)) EXPECT_EQ(told(record), 0) << record.tick;
}

// Off, with a force or without, or on without one, it is as if it were not there: every number that both
// have, bit for bit.
TEST(VibrotactileInAWorld, OffIsAsIfItWereNotThere) {
  const SceneDesc on = finger_scene();
  SceneDesc off = on, none = on;
  off.vibrotactile_motion->gain = 0;
  off.vibrotactile_motion->lateral_force = 2;
  none.vibrotactile_motion.reset();
  const auto with = swept(on), silent = swept(off), without = swept(none);
  double most = 0;
  for (std::size_t i = 0; i < without.size(); ++i) {
    ASSERT_EQ(bytes_of(silent[i]), bytes_of(without[i])) << i;
    ASSERT_EQ(bytes_of(with[i]), bytes_of(without[i])) << i;
    EXPECT_FALSE(without[i].vibrotactile_motion);
    EXPECT_EQ(told(silent[i]), 0);
    most = std::max(most, told(with[i]));
  }
  EXPECT_GT(most, 12);
}

TEST(VibrotactileInAWorld, AStopSilencesWithinTwoMilliseconds) {
  constexpr int stop = 860;  // in the window
  const auto records = swept(finger_scene(), 0.1, -0.2e-3, {{stop, {Command::Kind::stop}}});
  EXPECT_GT(told(records[stop - 1]), 12);
  EXPECT_LE(told(records[stop]), 0.51 * told(records[stop - 1]));
  for (std::size_t i = stop + 1; i < records.size(); ++i) {
    EXPECT_EQ(told(records[i]), 0) << i;
    EXPECT_TRUE(records[i].vibrotactile_motion->command.stopping);
  }
}

TEST(VibrotactileInAWorld, ADamagedSampleSilences) {
  const SceneDesc desc = finger_scene();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    World world = expect(World::build(desc));
    StepResult result;
    for (int i = 0; i < 900; ++i) {
      const double x = i < 600 ? -0.02 : -0.02 + 1e-4 * (i - 600);
      result = step(world, at({Quat::Identity(), Vec3(x, -0.2e-3, 0)}), {});
    }
    EXPECT_GT(told(result.record), 0);
    for (int i = 0; i < 50; ++i) {
      result = step(world, at({Quat::Identity(), Vec3(bad, 0, 0)}), {});
      EXPECT_TRUE(std::isfinite(told(result.record)));
      if (i > 0) EXPECT_EQ(told(result.record), 0);
    }
  }
}

TEST(VibrotactileInAWorld, SwitchedByItsCommand) {
  const auto records = swept(finger_scene(), 0.1, -0.2e-3,
                             {{840, {Command::Kind::vibrotactile_gain, 0}},
                              {870, {Command::Kind::vibrotactile_gain, 0.5}},
                              {880, {Command::Kind::impact_gain, 0}}});
  EXPECT_GT(told(records[839]), 12);
  for (int i = 840; i < 870; ++i) EXPECT_EQ(told(records[static_cast<std::size_t>(i)]), 0);
  EXPECT_EQ(records[885].vibrotactile_motion->gain, 0.5);
  EXPECT_NEAR(told(records[870]), 0.5 * told(swept(finger_scene())[870]), 0.05);
}

// Switched off in the window the force goes with it, in one update; switched on again it comes back.
TEST(VibrotactileInAWorld, TheLateralForceIsSwitchedWithIt) {
  SceneDesc desc = finger_scene();
  desc.vibrotactile_motion->lateral_force = 2;
  const auto records =
      swept(desc, 0.1, -0.2e-3,
            {{840, {Command::Kind::vibrotactile_gain, 0}}, {870, {Command::Kind::vibrotactile_gain, 1}}});
  const auto force = [&](std::size_t i) { return records[i].vibrotactile_motion->force; };
  EXPECT_NEAR(force(839), -2, 1e-9);
  for (std::size_t i = 840; i < 885; ++i) EXPECT_LE(std::abs(force(i) - force(i - 1)), 0.2 + 1e-9) << i;
  for (std::size_t i = 851; i < 870; ++i) EXPECT_EQ(force(i), 0) << i;
  EXPECT_NEAR(force(885), -2, 1e-9);
}

// On a device that pushes: 2 N against the sweep, without a step beyond the slew limit, and it takes energy.
TEST(VibrotactileInAWorld, TheLateralForceIsContinuousAndTakesEnergy) {
  SceneDesc desc = finger_scene(), none = desc;
  desc.vibrotactile_motion->lateral_force = 2;
  none.vibrotactile_motion.reset();
  const auto with = swept(desc, 0.2), without = swept(none, 0.2);
  const double largest_step = desc.device.max_force / kSlewTime * desc.tick_s;
  double most = 0, before = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const double force = with[i].device_F_H_D.force.x() - without[i].device_F_H_D.force.x();
    EXPECT_LE(std::abs(force - before), largest_step + 1e-12) << i;
    EXPECT_LE(force * with[i].vibrotactile_motion->direction, 1e-12) << i;
    EXPECT_GE(with[i].energy_port, kPortBound) << i;
    most = std::max(most, std::abs(force));
    before = force;
  }
  EXPECT_NEAR(most, 2, 1e-9);
  EXPECT_GT(with.back().energy_port - without.back().energy_port, 0.8 * 2 * 2 * 0.01);
}

// In a simulated hand that sweeps, halts and turns round in the window, the force neither chatters nor gives.
TEST(VibrotactileInAWorld, TheLateralForceDoesNotChatter) {
  for (const double mass : {0.072, 0.3}) {
    SceneDesc desc = finger_scene();
    desc.vibrotactile_motion->lateral_force = 2;
    desc.velocity = {};
    desc.device.handle_mass = mass;
    const auto pose = [](double x) { return Pose{Quat::Identity(), Vec3(x, -0.5e-3, 0)}; };
    HandTask task{.path = HandPath({{pose(-0.03), 0, 0.6},
                                    {pose(0.03), 0.5, 0.2},
                                    {pose(-0.03), 0.3, 0.2},
                                    {pose(0.005), 0.4, 0.5},
                                    {pose(-0.005), 0.3, 0.5}}),
                  .hand = {},
                  .X_HT = {},
                  .mapping = desc.mapping};
    SimulatedDevice device({.device = desc.device, .tick_s = desc.tick_s}, task);
    World world = expect(World::build(desc));
    int changes = 0;
    double last = 0, deepest = 0, most = 0;
    for (int i = 0; i < 4000; ++i) {
      TickEvent event;
      run_tick(world, device, {}, event);
      deepest = std::min(deepest, event.record.energy_port);
      const double force = event.record.vibrotactile_motion->force;
      most = std::max(most, std::abs(force));
      if (std::abs(force) < 0.2) continue;
      changes += force * last < 0;
      last = force;
    }
    EXPECT_GE(deepest, kPortBound) << mass;
    EXPECT_NEAR(most, 2, 1e-9) << mass;
    EXPECT_LE(changes, 12) << mass;
  }
}

TEST(VibrotactileInAWorld, AFallbackIsForDevicesThatCannotPush) {
  SceneDesc desc = finger_scene();
  desc.vibrotactile_motion->use = VibrotactileUse::fallback;
  for (const TickRecord& record : swept(desc)) ASSERT_FALSE(record.vibrotactile_motion);

  // Against a wall on the right: as strong as the force that the hand should feel, pressing on, not leaving.
  desc.device = fingertip(false);
  desc.scene_field = field_of(box_mesh({0, -0.05, -0.05}, {0.05, 0.05, 0.05}));
  int vibrating = 0;
  for (const TickRecord& record : swept(desc, 0.1, 0)) {
    const double F = -record.coupling_F_T_W.force.x();  // on the hand
    const int direction = record.vibrotactile_motion->direction;
    if (record.X_WH.p.x() < -1e-3) EXPECT_EQ(told(record), 0) << record.tick;
    if (direction * F > 0) EXPECT_EQ(told(record), 0) << record.tick;
    if (direction * F < -0.05) {
      vibrating += direction > 0;  // leaving, it feels the damper of the coupling
      EXPECT_GT(told(record), 0) << record.tick;
      // both together at most 2 x .76 of what the force asks for
      EXPECT_LT(told(record), 1.6 * std::min(1.0, -direction * F) * desc.vibrotactile_motion->strength);
    }
  }
  EXPECT_NEAR(vibrating, 200, 5);
}

TEST(VibrotactileInAWorld, WhatCannotBeIsRefusedWithASentence) {
  const auto refused = [](const SceneDesc& desc, const std::string& part) {
    const Result<World> world = World::build(desc);
    EXPECT_FALSE(world);
    if (!world) EXPECT_NE(world.error().sentence.find(part), std::string::npos) << world.error().sentence;
  };
  SceneDesc desc = finger_scene();
  desc.vibrotactile_motion->carrier_Hz = 500;
  desc.device.vibrotactile->channels[1].rate_Hz = 1000;
  refused(desc, "'right'");
  desc = finger_scene();
  desc.device.vibrotactile->channels[0].name = "top";
  refused(desc, "'left'");
  desc = finger_scene();
  desc.device.vibrotactile->channels[0].quality = 0.5;
  refused(desc, "quality");
  desc = finger_scene();
  desc.vibrotactile_motion->axis_W.setZero();
  refused(desc, "axis");
}

}  // namespace
}  // namespace fulcrum::test
