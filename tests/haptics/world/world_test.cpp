// Truths: springs in series, a box on four springs, saturation (F_s (1 - exp(-k d / F_s))), stops and ramps
// as in the contracts.

#include "haptics/world/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

Pose pose(const Vec3& p) {
  return {Quat::Identity(), p};
}

TEST(World, CouplingAndSurfaceAreSpringsInSeries) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.001);
  desc.contact.stiffness = 5000;
  desc.coupling.stiffness = 1000;
  desc.coupling.max_force = 1e6;
  World world = expect(World::build(desc));
  const StepResult last = hold(world, pose({0, -3e-3, 0}), 3000);
  const double force = 1000.0 * 5000.0 * 3e-3 / 6000.0;
  EXPECT_NEAR(last.record.coupling_F_T_W.force.y(), -force, 1e-3 * force);
  EXPECT_NEAR(last.record.contact_F_T_W.force.y(), force, 1e-3 * force);
  EXPECT_NEAR(last.record.depth_max, force / 5000, 1e-3 * force / 5000);
  EXPECT_NEAR(last.command.F_H_D.force.y(), force + desc.device.handle_weight, 2e-3 * force);
}

TEST(World, SpringsSaturate) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.001);
  World world = expect(World::build(desc));
  const StepResult last = hold(world, pose({0, -30e-3, 0}), 3000);
  const double d = 30e-3 + last.record.X_WT.p.y();
  const double F_s = desc.coupling.max_force;
  const double force = F_s * (1 - std::exp(-desc.coupling.stiffness * d / F_s));
  EXPECT_NEAR(last.record.contact_F_T_W.force.y(), force, 1e-3 * force);
}

TEST(World, BoxStandsOnItsCornersUnderItsWeight) {
  const double a = 0.03;
  SceneDesc desc = floor_scene({{a, -0.01, a}, {-a, -0.01, a}, {a, -0.01, -a}, {-a, -0.01, -a}}, 0.01);
  desc.contact.stiffness = 2000;
  desc.tool.weight = true;
  World world = expect(World::build(desc));
  // The handle sinks to where the coupling carries nothing: the box then stands by itself.
  double y = 0.01;
  StepResult last;
  for (int i = 0; i < 6000; ++i) {
    last = step(world, at(pose({0, y, 0})), {});
    y = last.record.X_WT.p.y();
  }
  EXPECT_NEAR(last.record.depth_max, 0.2 * 9.80665 / (4 * 2000), 0.01 * 0.2 * 9.80665 / (4 * 2000));
  EXPECT_EQ(last.record.regions, 4);
}

TEST(World, TorqueWindsUpToHalfATurnAndBeyond) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.05);
  desc.coupling.angular_stiffness = 0.5;
  desc.tool.inertia_T = Mat3::Identity() * 1e6;  // held
  World world = expect(World::build(desc));
  double before = 0;
  for (double angle = 0; angle < 1.5 * std::numbers::pi; angle += 0.002) {
    const StepResult result = step(world, at({quaternion_exp(Vec3(angle, 0, 0)), Vec3(0, 0.05, 0)}), {});
    const double spring = desc.coupling.max_torque * -std::expm1(-0.5 * angle / desc.coupling.max_torque);
    EXPECT_GE(result.record.coupling_F_T_W.torque.x(), std::min(spring, before) - 1e-3) << angle;
    before = spring;
  }
}

TEST(World, DeviceWithoutTorqueMotorsGetsForceAlone) {
  World world = expect(World::build(floor_scene({Vec3::Zero()}, 0.05)));
  const StepResult last = hold(world, {quaternion_exp(Vec3(0.5, 0, 0)), Vec3(0.002, 0.05, 0)}, 20);
  EXPECT_NE(last.record.coupling_F_T_W.torque.norm(), 0);
  EXPECT_EQ(last.command.F_H_D.torque.norm(), 0);
}

TEST(World, ForceRampsInStopsWithin2msAndWaitsForAcknowledgement) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.0);
  World world = expect(World::build(desc));
  const Pose pushed = pose({0, -5e-3, 0});
  const double early = hold(world, pushed, 100).command.F_H_D.force.norm();
  EXPECT_LT(early, 0.5 * hold(world, pushed, 500).command.F_H_D.force.norm());
  const double before = hold(world, pushed, 500).command.F_H_D.force.norm();
  ASSERT_GT(before, 1);

  const Command stop{Command::Kind::stop}, acknowledge{Command::Kind::acknowledge};
  const StepResult first = step(world, at(pushed), {&stop, 1});
  EXPECT_NEAR(first.command.F_H_D.force.norm(), 0.5 * before, 1e-9);
  EXPECT_TRUE(first.record.faults & kStopRequested);
  EXPECT_EQ(hold(world, pushed, 1).command.F_H_D.force.norm(), 0);
  const StepResult later = hold(world, pushed, 1000);
  EXPECT_EQ(later.command.F_H_D.force.norm(), 0);
  EXPECT_TRUE(later.record.stopped);
  EXPECT_TRUE(later.record.faults & kStopRequested) << "the reason stays to be seen";

  step(world, at(pushed), {&acknowledge, 1});
  EXPECT_NEAR(hold(world, pushed, 249).record.force_gain, 0.5, 1e-9);
  EXPECT_NEAR(hold(world, pushed, 500).command.F_H_D.force.norm(), before, 0.01);
}

TEST(World, BadSamplesStopTheForceAndTheToolStays) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  struct Case {
    DeviceSample sample;
    Fault fault;
  };
  std::vector<Case> cases;
  const Pose good = pose({0, 0.02, 0});
  cases.push_back({at(pose({nan, 0, 0})), kNotFinite});
  cases.push_back({at(pose({0, inf, 0})), kNotFinite});
  cases.push_back({at({Quat(nan, 0, 0, 0), Vec3::Zero()}), kNotFinite});
  cases.push_back({at({Quat(0, 0, 0, 0), Vec3::Zero()}), kNotFinite});
  DeviceSample stale = at(good);
  stale.age = 0.021;
  cases.push_back({stale, kSampleStale});
  stale.age = nan;
  cases.push_back({stale, kNotFinite});
  DeviceSample lost = at(good);
  lost.connected = false;
  cases.push_back({lost, kDeviceLost});
  for (const Case& bad : cases) {
    World world = expect(World::build(floor_scene({Vec3::Zero()}, 0.02)));
    hold(world, good, 600);
    const StepResult result = step(world, bad.sample, {});
    EXPECT_TRUE(result.record.faults & bad.fault);
    EXPECT_TRUE(result.record.stopped);
    const Command acknowledge{Command::Kind::acknowledge};
    EXPECT_TRUE(step(world, bad.sample, {&acknowledge, 1}).record.stopped) << "the cause is still there";
    for (int i = 0; i < 100; ++i) {
      const StepResult later = step(world, bad.sample, {});
      ASSERT_TRUE(later.record.X_WT.is_finite());
      ASSERT_TRUE(later.command.F_H_D.is_finite());
      EXPECT_NEAR(later.record.X_WT.p.y(), 0.02, 1e-3);
    }
    step(world, at(good), {&acknowledge, 1});
    EXPECT_FALSE(hold(world, good, 600).record.stopped);
  }
}

// The floor is 40 mm thick and its field knows 10 mm: a tool in its middle cannot be told which way is out.
TEST(World, ToolThatStartsDeepInsideStopsTheForce) {
  World world = expect(World::build(floor_scene({Vec3::Zero()}, -0.02)));
  const StepResult result = step(world, at(pose({0, -0.02, 0})), {});
  EXPECT_TRUE(result.record.faults & kToolInside);
  EXPECT_TRUE(result.record.stopped);
  EXPECT_EQ(hold(world, pose({0, 0.02, 0}), 10).command.F_H_D.force.norm(), 0);
}

TEST(World, ForceIsClampedAndSlewLimited) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.coupling.max_force = 50;
  desc.mapping.force_scale = 1;
  World world = expect(World::build(desc));
  hold(world, pose({0, 0.02, 0}), 600);
  Vec3 before = hold(world, pose({0, 0.02, 0}), 1).command.F_H_D.force;
  for (int i = 0; i < 200; ++i) {
    const StepResult result = step(world, at(pose({0.2, 0.02, 0})), {});
    EXPECT_LE(result.command.F_H_D.force.norm(), desc.device.max_force * (1 + 1e-12));
    EXPECT_LE((result.command.F_H_D.force - before).norm(),
              desc.device.max_force / kSlewTime * 1e-3 * (1 + 1e-9));
    before = result.command.F_H_D.force;
  }
}

// A handle that teleports through the floor, every tick somewhere else: no shell point gets past it.
TEST(World, NoHandleSpeedTakesTheToolThroughTheFloor) {
  SceneDesc desc = floor_scene({{0.02, -0.01, 0}, {-0.02, -0.01, 0}, {0, 0.01, 0.02}}, 0.02);
  World world = expect(World::build(desc));
  double deepest = 0;
  for (int i = 0; i < 20000; ++i) {
    const double jump = i % 7 == 0 ? 0.5 : -0.5;
    const StepResult result = step(world, at({quaternion_exp(Vec3(0, 0, 0.3 * i)), Vec3(0, jump, 0)}), {});
    deepest = std::max(deepest, result.record.depth_max);
    ASSERT_TRUE(result.record.X_WT.is_finite());
  }
  EXPECT_LT(deepest, 2e-3);
}

TEST(World, ClutchLeavesTheToolAndGivesNoForce) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.mapping.clutch_button = 0;
  World world = expect(World::build(desc));
  hold(world, pose({0, 0.02, 0}), 600);
  DeviceSample sample = at(pose({0, 0.02, 0}));
  sample.buttons = 1;
  StepResult result;
  for (int i = 0; i < 500; ++i) {
    sample.X_DH.p.x() += 1e-4;
    result = step(world, sample, {});
  }
  EXPECT_NEAR(result.record.X_WT.p.x(), 0, 1e-5);
  EXPECT_NEAR(result.command.F_H_D.force.norm(), desc.device.handle_weight, 1e-6);
  sample.buttons = 0;
  for (int i = 0; i < 500; ++i) {
    sample.X_DH.p.x() += 1e-4;
    result = step(world, sample, {});
  }
  EXPECT_NEAR(result.record.X_WT.p.x(), 0.05, 3e-3);
}

// A hand need not be where the scene begins: the first sample that can be used takes hold of the tool where
// it is.
TEST(World, AHeldDeviceTakesHoldOfTheToolWhereItIs) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.mapping.engages_at_start = true;
  World world = expect(World::build(desc));
  const Pose elsewhere{quaternion_exp(Vec3(0.3, -0.7, 0.2)), Vec3(0.06, -0.05, 0.04)};
  DeviceSample nothing = at(elsewhere);
  nothing.X_DH.p.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(step(world, nothing, {}).record.stopped);
  const Command acknowledge{Command::Kind::acknowledge};
  for (int i = 0; i < 5; ++i) step(world, at(elsewhere), {&acknowledge, 1});
  const StepResult held = hold(world, elsewhere, 1000);
  EXPECT_FALSE(held.record.stopped);
  EXPECT_NEAR((held.record.X_WT.p - desc.tool.X_WT_start.p).norm(), 0, 1e-6);
  EXPECT_NEAR(rotation_vector(held.record.X_WT.q * desc.tool.X_WT_start.q.conjugate()).norm(), 0, 1e-6);
  EXPECT_NEAR(held.command.F_H_D.force.norm(), desc.device.handle_weight, 1e-6);
  // From there on it moves and turns with the hand.
  const Pose start = desc.tool.X_WT_start * desc.tool.X_HT.inverse();
  const Quat turn = quaternion_exp(Vec3(0, 1e-4, 0));
  Pose hand = elsewhere;
  Quat turned = Quat::Identity();
  for (int i = 0; i < 1000; ++i) {
    hand.p.x() += 1e-5;
    hand.q = turn * hand.q;
    turned = turn * turned;
    const Pose X_WH = step(world, at(hand), {}).record.X_WH;
    ASSERT_NEAR((X_WH.p - start.p - (hand.p - elsewhere.p)).norm(), 0, 1e-9) << i;
    ASSERT_NEAR(rotation_vector(X_WH.q * (turned * start.q).conjugate()).norm(), 0, 1e-9) << i;
  }
}

TEST(World, RefusesWhatTheTickCannotHold) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.coupling.stiffness = 0.26 * 0.2 * 1e6;
  const Result<World> stiff = World::build(desc);
  ASSERT_FALSE(stiff);
  EXPECT_NE(stiff.error().sentence.find("at most 5e+04"), std::string::npos) << stiff.error().sentence;
  desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.tool_shell = nullptr;
  EXPECT_FALSE(World::build(desc));
  desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.tool.mass = 0;
  EXPECT_FALSE(World::build(desc));
}

// A contact stiffness far past what the tick can hold is lowered, and stays stable.
TEST(World, AnyContactStiffnessStaysStable) {
  for (double stiffness : {1e-1, 1e2, 1e5, 1e8}) {
    SceneDesc desc = floor_scene({{0.02, -0.01, 0.02}, {-0.02, -0.01, 0.02}, {0, -0.01, -0.02}}, 0.012);
    desc.contact.stiffness = stiffness;
    World world = expect(World::build(desc));
    hold(world, pose({0, 0.008, 0}), 3000);
    const StepResult a = hold(world, pose({0, 0.008, 0}), 1);
    const StepResult b = hold(world, pose({0, 0.008, 0}), 100);
    EXPECT_LT((a.record.X_WT.p - b.record.X_WT.p).norm(), 1e-8) << stiffness;
    EXPECT_LT(b.record.V_WT.w.norm(), 1e-4) << stiffness;
  }
}

TEST(World, SameInputSameBits) {
  const auto run = [] {
    World world = expect(World::build(floor_scene({{0.02, -0.01, 0}, {-0.02, -0.01, 0}}, 0.02)));
    StepResult last;
    for (int i = 0; i < 3000; ++i)
      last = step(world,
                  at({quaternion_exp(Vec3(0.1 * std::sin(i * 0.01), 0, 0.2)),
                      Vec3(0.01 * std::sin(i * 0.003), 0.01 * std::cos(i * 0.004), 0)}),
                  {});
    return last.record;
  };
  const TickRecord a = run(), b = run();
  EXPECT_EQ(a.X_WT.p, b.X_WT.p);
  EXPECT_EQ(a.X_WT.q.coeffs(), b.X_WT.q.coeffs());
  EXPECT_EQ(a.energy_port, b.energy_port);
}

}  // namespace
}  // namespace fulcrum::test
