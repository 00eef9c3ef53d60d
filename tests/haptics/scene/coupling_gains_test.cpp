#include "haptics/scene/coupling_gains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/device/linear_loop.h"
#include "haptics/device/simulated_device.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

SceneDesc hanging_scene() {
  SceneDesc scene = floor_scene({Vec3(0, -0.01, 0)}, 0.1);
  scene.integrator = Integrator::implicit_euler;
  scene.velocity.kind = VelocityEstimatorKind::low_pass;
  return scene;
}

// How far a pushed handle, in no hand, swings about a tool that does not move: in its last tenth of a second
// and in its second. The push is small enough for passivity control to have nothing to take back.
struct Swings {
  double early, late;  // m, from least to largest
};
Swings swing(SceneDesc scene, double push) {
  scene.device.handle_weight = 0;
  SimulatedDeviceDesc desc;
  desc.device = scene.device;
  desc.tick_s = scene.tick_s;
  const Pose X_DH = scene.mapping.handle_in_device(scene.tool.X_WT_start);
  SimulatedDevice device(desc, X_DH);
  World world = expect(World::build(scene));
  hold(world, X_DH, static_cast<int>(0.6 / scene.tick_s));  // past the ramp
  device.push({push, 0, 0});
  const int ticks = static_cast<int>(1 / scene.tick_s);
  std::array<double, 2> least{1, 1}, most{-1, -1};
  for (int i = 0; i < ticks; ++i) {
    const StepResult result = step(world, device.read(), {});
    device.write(result.command);
    const double x = device.X_DH().p.x();
    const int tenth = 10 * i / ticks;
    if (tenth != 1 && tenth != 9) continue;
    const std::size_t which = tenth == 1 ? 0 : 1;
    least[which] = std::min(least[which], x);
    most[which] = std::max(most[which], x);
  }
  return {most[0] - least[0], most[1] - least[1]};
}

// A device without friction and counts on a tool too heavy to move is the linear loop.
SceneDesc linear_scene(VelocityEstimatorKind kind) {
  SceneDesc scene = hanging_scene();
  scene.velocity.kind = kind;
  scene.device.friction = scene.device.angular_friction = 0;
  scene.device.encoder_step = 1e-12;
  scene.device.max_force = 1e3;
  scene.coupling.max_force = 1e3;
  scene.tool.mass = 1e4;
  scene.tool.inertia_T = Mat3::Identity() * 10;
  scene.coupling.damping_ratio = 2e-3;
  return scene;
}

TEST(CouplingLimits, AreWhereALetGoHandleBeginsToSwing) {
  for (const VelocityEstimatorKind kind :
       {VelocityEstimatorKind::difference, VelocityEstimatorKind::low_pass}) {
    for (const double scale : {1.0, 2.5}) {
      SceneDesc scene = linear_scene(kind);
      scene.mapping.position_scale = scale;
      const double limit = coupling_limits(scene).stiffness;
      for (const double part : {0.95, 1.05}) {
        scene.coupling.stiffness = part * limit;
        const Swings swings = swing(scene, 1e-5);
        if (part < 1)
          EXPECT_LT(swings.late, 0.8 * swings.early) << limit;
        else
          EXPECT_GT(swings.late, 1.2 * swings.early) << limit;
      }
    }
  }
}

// 1/s, of the swing of a handle and a tool that are both let go, in the scene, over two seconds.
double simulated_growth(const SceneDesc& scene) {
  SimulatedDeviceDesc desc;
  desc.device = scene.device;
  desc.tick_s = scene.tick_s;
  const Pose X_DH = scene.mapping.handle_in_device(scene.tool.X_WT_start);
  SimulatedDevice device(desc, X_DH);
  World world = expect(World::build(scene));
  hold(world, X_DH, static_cast<int>(0.6 / scene.tick_s));  // past the ramp
  device.push({1e-4, 0, 0});                                // less than passivity control would take back
  const int second = static_cast<int>(1 / scene.tick_s);
  std::array<double, 4> least, most;
  least.fill(1);
  most.fill(-1);
  for (int i = 0; i < 4 * second; ++i) {
    const StepResult result = step(world, device.read(), {});
    device.write(result.command);
    EXPECT_EQ(result.record.faults, 0u);
    const double x = result.record.X_WH.p.x() - result.record.X_WT.p.x();
    const auto at = static_cast<std::size_t>(i / second);
    least[at] = std::min(least[at], x);
    most[at] = std::max(most[at], x);
  }
  return std::log((most[3] - least[3]) / (most[1] - least[1])) / 2;
}

TEST(CouplingLimits, AFreeToolSwingsAsTheExactLoop) {
  const WallLoop loop{.axis = {DeviceDesc{}.handle_mass, 0.5, 0, 0}};
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::momentum, Integrator::implicit_euler}) {
    for (const double K : {100.0, 183.0, 400.0}) {
      for (const double tool_mass : {0.0144, 0.072}) {
        if (integrator == Integrator::implicit_euler && tool_mass < 0.05)
          continue;  // it dies away within a second
        SceneDesc scene = linear_scene(VelocityEstimatorKind::difference);
        scene.integrator = integrator;
        scene.device.handle_weight = 0;
        scene.device.damping = loop.axis.damping;
        scene.tool.mass = tool_mass;
        scene.coupling.damping_ratio = 0;
        scene.coupling.stiffness = K;
        const double growth = exact_growth(loop, {K, 0}, FreeTool{tool_mass, integrator});
        EXPECT_NEAR(simulated_growth(scene), growth, 0.03 * std::abs(growth) + 2e-3)
            << tool_mass << ", " << K;
      }
    }
  }
}

// Where the tool is lighter than the handle, a still one would be let through with several times what a free
// one holds.
TEST(CouplingLimits, AFreeToolHoldsLess) {
  SceneDesc scene = linear_scene(VelocityEstimatorKind::difference);
  scene.device.damping = 0.5;
  scene.tool.mass = scene.device.handle_mass / 5;
  scene.coupling.damping_ratio = 0;
  scene.integrator = Integrator::semi_implicit_euler;
  const double limit = coupling_limits(scene).stiffness;
  EXPECT_NEAR(limit, 166.4, 0.5);
  scene.contact.response = ContactResponse::constraint;  // whose tool has no mass
  EXPECT_NEAR(coupling_limits(scene).stiffness, 6 * limit, 0.005 * 6 * limit);
  scene.contact.response = ContactResponse::penalty;
  scene.integrator = Integrator::implicit_euler;  // which damps what swings
  EXPECT_GT(coupling_limits(scene).stiffness, 5 * limit);
  scene.integrator = Integrator::semi_implicit_euler;
  scene.coupling.stiffness = 2 * limit;
  const auto sentence = beyond_limits(scene);
  ASSERT_TRUE(sentence);
  EXPECT_NE(sentence->find("holds at most 166"), std::string::npos) << *sentence;
}

// b > K T / 2 (1 + m / m_tool), without damping in the coupling.
TEST(CouplingLimits, AFreeToolWithoutDampingFollowsTheory) {
  for (const double tool_mass : {0.0144, 0.072, 0.3}) {
    SceneDesc scene = linear_scene(VelocityEstimatorKind::difference);
    scene.device.damping = 1;
    scene.integrator = Integrator::semi_implicit_euler;
    scene.tool.mass = tool_mass;
    scene.coupling.damping_ratio = 0;
    const double theory =
        2 * scene.device.damping / scene.tick_s / (1 + scene.device.handle_mass / tool_mass);
    EXPECT_NEAR(coupling_limits(scene).stiffness, theory, 0.03 * theory) << tool_mass;
  }
}

TEST(CouplingLimits, FollowScalesTickAndMotors) {
  SceneDesc scene = hanging_scene();
  const StiffnessLimits plain = coupling_limits(scene);
  EXPECT_GT(plain.stiffness, 800);
  EXPECT_EQ(plain.angular_stiffness, std::numeric_limits<double>::infinity()) << "it renders no torque";
  scene.mapping.force_scale = 4;
  EXPECT_LT(coupling_limits(scene).stiffness, plain.stiffness);
  scene = hanging_scene();
  scene.tick_s = 5e-3;
  EXPECT_LT(coupling_limits(scene).stiffness, plain.stiffness);
  scene = hanging_scene();
  scene.velocity.cutoff_Hz = 10;
  EXPECT_LT(coupling_limits(scene).stiffness, plain.stiffness);
  scene = hanging_scene();
  scene.device.renders_force = false;
  EXPECT_EQ(coupling_limits(scene).stiffness, std::numeric_limits<double>::infinity());
}

TEST(CouplingGains, SuitTheDeviceWhereNothingIsGiven) {
  for (const bool renders_torque : {false, true}) {
    for (const double tick_s : {5e-4, 1e-3, 5e-3}) {
      SceneDesc scene = hanging_scene();
      scene.tick_s = tick_s;
      scene.device.renders_torque = renders_torque;
      scene.device.max_torque = renders_torque ? 0.2 : 0;
      scene.coupling = tune_coupling({}, scene);
      EXPECT_FALSE(beyond_limits(scene)) << *beyond_limits(scene);
      EXPECT_GT(scene.coupling.stiffness, 50) << tick_s;
      EXPECT_LE(scene.coupling.max_force, scene.device.max_force);
      EXPECT_GT(scene.coupling.angular_stiffness, 0);
      EXPECT_GT(scene.coupling.max_torque, 0);
      EXPECT_TRUE(World::build(scene)) << tick_s;
      EXPECT_LT(swing(scene, 0.05).late, 3 * scene.device.encoder_step) << tick_s;
    }
  }
}

TEST(CouplingGains, WhatIsGivenStays) {
  const CouplingDesc coupling = tune_coupling(
      {.stiffness = 123, .angular_stiffness = 0.4, .damping_ratio = 0.7, .max_force = 2, .max_torque = 0.03},
      hanging_scene());
  EXPECT_EQ(coupling.stiffness, 123);
  EXPECT_EQ(coupling.angular_stiffness, 0.4);
  EXPECT_EQ(coupling.damping_ratio, 0.7);
  EXPECT_EQ(coupling.max_force, 2);
  EXPECT_EQ(coupling.max_torque, 0.03);
}

TEST(CouplingGains, BeyondTheLimitASentenceSaysSo) {
  SceneDesc scene = hanging_scene();
  EXPECT_FALSE(beyond_limits(scene));
  scene.coupling.stiffness = 1.5 * coupling_limits(scene).stiffness;
  const auto sentence = beyond_limits(scene);
  ASSERT_TRUE(sentence);
  EXPECT_NE(sentence->find("coupling.stiffness is "), std::string::npos) << *sentence;
  EXPECT_NE(sentence->find("holds at most"), std::string::npos) << *sentence;
}

// By differences, of a handle without damping: the swing z^2 - (1 - b/2) z + b/2 with b = B T / m is stable
// up to b = 2.
TEST(LateralLimits, OfAFreeMassIsTwiceItsMassATick) {
  for (const double tick_s : {1e-2, 1e-3}) {
    for (const double scale : {1.0, 2.5}) {
      SceneDesc scene = hanging_scene();
      scene.tick_s = tick_s;
      scene.velocity.kind = VelocityEstimatorKind::difference;
      scene.device.damping = 0;
      scene.mapping.position_scale = scale;
      const double limit = 2 * scene.device.handle_mass / tick_s / scale;
      EXPECT_NEAR(damping_limit(scene), limit, 1e-3 * limit) << tick_s;
      VibrotactileMotionDesc& motion = scene.vibrotactile_motion.emplace();
      for (const double part : {0.0, 0.99, 1.01}) {
        motion.lateral_force = part * limit * motion.full_speed;
        EXPECT_EQ(!advice_on_effects(scene, scene).empty(), part > 1) << tick_s << ' ' << part;
      }
    }
  }
}

// 2 N in full from 0.1 m/s: a device of 72 g holds it at 1 kHz, and not at 100 Hz.
TEST(LateralLimits, ASentenceSaysWhereTheTickIsTooSlow) {
  SceneDesc scene = hanging_scene();
  scene.velocity.kind = VelocityEstimatorKind::difference;
  scene.vibrotactile_motion.emplace().lateral_force = 2;
  EXPECT_TRUE(advice_on_effects(scene, scene).empty());
  scene.tick_s = 1e-2;
  const std::vector<std::string> advice = advice_on_effects(scene, scene);
  ASSERT_EQ(advice.size(), 1U);
  EXPECT_NE(advice[0].find("full_speed is 20 N s/m"), std::string::npos) << advice[0];
  scene.device.renders_force = false;
  EXPECT_TRUE(advice_on_effects(scene, scene).empty());
}

}  // namespace
}  // namespace fulcrum::test
