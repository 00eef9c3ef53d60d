// Stiffnesses, masses, inertias and ticks far from any that a scenario names, in a whole loop.

#include <gtest/gtest.h>

#include "haptics/math/rotation.h"
#include "tests/haptics/extremes/closed_loop.h"

namespace fulcrum::test {
namespace {

constexpr std::uint32_t kSaysSo =  // one of these has to be there when a loop does not come to rest
    kStoppingFaults | kForceClamped | kMotorClamped | kEnergyBound | kPassivityControl;

TEST_P(EveryResponseThatRests, AnyContactStiffnessComesToRest) {
  for (double k = 1e-1; k <= 1.01e8; k *= 10) {
    SceneDesc scene = answering(pressing_scene());
    scene.contact.stiffness = k;
    const Verdict verdict = run_closed_loop(scene, pressing_hand(), 3);
    EXPECT_TRUE(verdict.at_rest()) << k << ": " << verdict.late_tool << " m, " << verdict.late_force << " N";
    EXPECT_FALSE(verdict.faults & kStoppingFaults) << k;
    EXPECT_LT(verdict.depth_max, 6e-3) << k;
  }
}

// Its depths jump by a voxel and so do its forces; what holds is that they stay that small.
TEST(Extremes, TheVoxelBaselineChattersByLessThanAVoxel) {
  for (double k = 1e-1; k <= 1.01e8; k *= 10) {
    SceneDesc scene = pressing_scene();
    scene.contact.response = ContactResponse::voxel;
    scene.contact.stiffness = k;
    const Verdict verdict = run_closed_loop(scene, hand_from_to({0, 0.013, 0}, {0, 0.001, 0}, 0.3), 3);
    EXPECT_TRUE(verdict.finite) << k;
    EXPECT_LT(verdict.late_tool, scene.scene_field->voxel_m()) << k;
    EXPECT_LE(verdict.force_max, scene.device.max_force * (1 + 1e-12)) << k;
    // Softer than the hand by far, the tool sinks past the eight voxels, and one, that are looked through:
    // that stops the force.
    EXPECT_EQ(verdict.faults & kStoppingFaults, k < 100 ? kToolInside + 0u : 0u) << k;
  }
}

// The damper of the coupling grows with the tool: 2 sqrt(k m). What the device can be given of it is about
// its own mass over a tick; from there on it buzzes, bounded by safety, and that is said.
TEST(Extremes, AnyToolMassComesToRestOrSaysWhyNot) {
  for (double mass = 1e-6; mass <= 101; mass *= 10) {
    SceneDesc scene = pressing_scene();
    scene.tool.mass = mass;
    scene.tool.inertia_T = Mat3::Identity() * (2.6e-4 * mass);
    const Verdict verdict = run_closed_loop(scene, pressing_hand(), 6);
    EXPECT_TRUE(verdict.finite) << mass;
    EXPECT_LE(verdict.force_max, scene.device.max_force * (1 + 1e-12)) << mass;
    EXPECT_FALSE(verdict.faults & kStoppingFaults) << mass;
    const double B = 2 * std::sqrt(scene.coupling.stiffness * mass);
    const bool can = B < scene.device.handle_mass / scene.tick_s;
    EXPECT_TRUE(verdict.at_rest() || (!can && (verdict.faults & kSaysSo)))
        << mass << ": " << verdict.late_tool << " m, " << verdict.late_force << " N, faults "
        << verdict.faults;
  }
}

TEST(Extremes, AMassThatTheTickCannotHoldIsRefusedWithoutImplicitEuler) {
  SceneDesc scene = pressing_scene();
  scene.integrator = Integrator::semi_implicit_euler;
  scene.tool.mass = 1e-6;
  const Result<World> world = World::build(scene);
  ASSERT_FALSE(world);
  EXPECT_NE(world.error().sentence.find("implicit_euler"), std::string::npos) << world.error().sentence;
}

TEST_P(EveryResponse, AHundredKilogramsOnTheHandAreClampedAndSaidSo) {
  SceneDesc scene = answering(pressing_scene());
  scene.tool.mass = 100;
  scene.tool.inertia_T = Mat3::Identity() * 0.026;
  scene.tool.weight = true;
  if (massless(GetParam())) {  // nothing but the coupling carries the weight
    const Result<World> world = World::build(scene);
    ASSERT_FALSE(world);
    EXPECT_NE(world.error().sentence.find("weighs 980.7 N"), std::string::npos) << world.error().sentence;
    return;
  }
  const Verdict verdict = run_closed_loop(scene, pressing_hand(), 3);
  EXPECT_TRUE(verdict.finite);
  EXPECT_LE(verdict.force_max, scene.device.max_force * (1 + 1e-12));
  EXPECT_TRUE(verdict.at_rest() || (verdict.faults & kSaysSo)) << verdict.faults;
}

TEST_P(EveryResponseThatRests, AnyRatioOfInertiasComesToRest) {
  for (const double ratio : {1e2, 1e4, 1e6}) {
    SceneDesc scene = answering(pressing_scene());
    scene.tool.inertia_T = Vec3(5e-3 / ratio, 5e-3, 5e-3).asDiagonal();  // a needle along x
    for (const Vec3& turn : {Vec3(1.5, 0, 0), Vec3(0, 1.5, 0), Vec3(0.8, 0.8, 0.8)}) {
      HandTask hand = pressing_hand();
      hand.path = HandPath({Waypoint{{Quat::Identity(), Vec3(0, 0.03, 0)}, 0, 0.6},
                            Waypoint{{quaternion_exp(turn), Vec3(0, 0.03, 0)}, 0.1, 0.5},
                            Waypoint{{Quat::Identity(), Vec3(0, 0.005, 0)}, 0.3, 0}});
      const Verdict verdict = run_closed_loop(scene, hand, 5);
      EXPECT_TRUE(verdict.at_rest()) << ratio << ": " << verdict.late_tool << " m, " << verdict.late_force
                                     << " N, " << verdict.last.V_WT.w.norm() << " rad/s";
      EXPECT_FALSE(verdict.faults & kStoppingFaults) << ratio;
    }
  }
}

// A hand of 4 N s/m on a device of .005: a held spring is stable up to about 2 b / T.
double holdable(const SceneDesc& scene, const HandTask& task) {
  return 2 * (scene.device.damping + task.hand.damping) / scene.tick_s;
}

// By the velocity of a scene, in a low-pass: by differences one count is a blow of B D / T, 0.8 N at 0.5 ms,
// and whether that keeps a loop going from count to count hangs on the micrometre at which it would rest.
TEST_P(EveryResponseThatRests, AnyTickComesToRestOrSaysWhyNot) {
  for (const double tick_s : {1e-4, 5e-4, 1e-3, 5e-3, 1e-2, 2e-2}) {
    for (const double deeper : {0.0, 3e-6, 9e-6, 15e-6, 21e-6}) {
      SceneDesc scene = answering(pressing_scene());
      scene.velocity.kind = VelocityEstimatorKind::low_pass;
      scene.tick_s = tick_s;
      const HandTask hand = hand_from_to({0, 0.013, 0}, {0, 0.005 - deeper, 0}, 0.3);
      const Verdict verdict = run_closed_loop(scene, hand, 4);
      EXPECT_TRUE(verdict.finite) << tick_s;
      EXPECT_LE(verdict.force_max, scene.device.max_force * (1 + 1e-12)) << tick_s;
      const bool can = scene.coupling.stiffness < 0.5 * holdable(scene, hand);
      EXPECT_TRUE(verdict.at_rest() || (!can && (verdict.faults & kSaysSo)))
          << tick_s << ", " << deeper << ": " << verdict.late_tool << " m, " << verdict.late_force
          << " N, faults " << verdict.faults;
    }
  }
}

// At 20 ms a device of .1 kg and .5 N s/m by itself holds 50.8 N/m: less comes to rest, in a hand or in none.
TEST_P(EveryResponseThatRests, TwentyMillisecondsHoldASoftCoupling) {
  SceneDesc scene = answering(pressing_scene());
  scene.tick_s = 20e-3;
  scene.coupling.stiffness = 40;
  scene.coupling.angular_stiffness = 0.02;
  const Verdict verdict = run_closed_loop(scene, pressing_hand(), 6);
  EXPECT_TRUE(verdict.at_rest()) << verdict.late_tool << " m, " << verdict.late_force << " N";
}

}  // namespace
}  // namespace fulcrum::test
