// Motions and samples that no hand and no bus should produce, and do.

#include <gtest/gtest.h>

#include <numbers>

#include "haptics/math/rotation.h"
#include "tests/haptics/extremes/closed_loop.h"

namespace fulcrum::test {
namespace {

TEST_P(EveryResponseThatRests, TenMetresASecondStopAtTheFloor) {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::implicit_euler}) {
    SceneDesc scene = answering(floor_scene(three_feet(), 1));
    scene.integrator = integrator;
    scene.coupling.max_force = 1e4;  // or the hand would only drag the tool after it
    World world = expect(World::build(scene));
    hold(world, {Quat::Identity(), Vec3(0, 1, 0)}, 600);
    double deepest = 0, fastest = 0;
    std::uint32_t faults = 0;
    StepResult result;
    for (int i = 0; i < 3000; ++i) {
      const double y = std::max(-0.005, 1 - 10 * 1e-3 * i);
      result = step(world, at({Quat::Identity(), Vec3(0, y, 0)}), {});
      ASSERT_TRUE(result.record.X_WT.is_finite() && result.command.F_H_D.is_finite());
      ASSERT_LE(result.command.F_H_D.force.norm(), scene.device.max_force * (1 + 1e-12));
      deepest = std::max(deepest, result.record.depth_max);
      fastest = std::max(fastest, -result.record.V_WT.v.y());
      faults |= result.record.faults;
    }
    EXPECT_GT(fastest, 9) << "it flies";
    EXPECT_LT(deepest, 2e-3);
    EXPECT_GT(result.record.X_WT.p.y(), 0.008) << "it stands on the floor";
    if (!massless(GetParam()))  // without mass a tick's rounds go to the floor and stop there by themselves
      EXPECT_TRUE(faults & kMotionLimited);
    EXPECT_FALSE(faults & kStoppingFaults);
  }
}

TEST_P(EveryResponseThatRests, SamplesThatComeTwiceLateOrNotAtAllComeToRest) {
  const auto seldom = [](int tick, int every) { return tick % every == 0; };
  const Mischief mischiefs[] = {// A sample that comes again: the bus gave nothing new in this tick.
                                [last = DeviceSample{}, &seldom](SimulatedDevice& device, int tick) mutable {
                                  if (tick == 0 || !seldom(tick, 3)) last = device.read();
                                  return last;
                                },
                                // Eight ticks without a sample, then one.
                                [last = DeviceSample{}](SimulatedDevice& device, int tick) mutable {
                                  if (tick % 100 >= 8 || tick == 0)
                                    last = device.read();
                                  else
                                    last.age += 1e-3;
                                  return last;
                                },
                                // A tick that takes two or three: the command is held.
                                [&seldom](SimulatedDevice& device, int tick) {
                                  if (seldom(tick, 7)) device.miss(1);
                                  if (seldom(tick, 31)) device.miss(2);
                                  return device.read();
                                }};
  for (const Mischief& mischief : mischiefs) {
    const Verdict verdict = run_closed_loop(answering(pressing_scene()), pressing_hand(), 4, mischief);
    EXPECT_TRUE(verdict.at_rest()) << verdict.late_tool << " m, " << verdict.late_force << " N";
    EXPECT_FALSE(verdict.faults & kStoppingFaults);
    EXPECT_LT(verdict.depth_max, 2e-3);
  }
}

TEST_P(EveryResponseThatRests, AStallOf60msInContactIsHarmless) {
  double furthest = 0, speed = 0;
  const Verdict verdict = run_closed_loop(
      answering(pressing_scene()), pressing_hand(), 4, [&](SimulatedDevice& device, int tick) {
        if (tick == 2500) {
          const double y = device.X_DH().p.y();
          for (int i = 0; i < 60; ++i) {
            device.miss(1);
            furthest = std::max(furthest, std::abs(device.X_DH().p.y() - y));
            speed = std::max(speed, device.velocity().norm());
          }
        }
        return device.read();
      });
  EXPECT_TRUE(verdict.at_rest()) << verdict.late_tool << " m, " << verdict.late_force << " N";
  EXPECT_LT(furthest, 10e-3);  // the hand pushes on against nothing; where it wants to be is 5 mm away
  EXPECT_LT(speed, 0.5);
  EXPECT_FALSE(verdict.faults & kStoppingFaults);
}

TEST_P(EveryResponse, HalfATurnAtOnceWindsUpAndComesBack) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, -2, 3)}) {
    for (const double angle : {std::numbers::pi, std::nextafter(std::numbers::pi, 4.0), 3.1}) {
      SceneDesc scene = answering(floor_scene(three_feet(), 0.05));
      World world = expect(World::build(scene));
      hold(world, {Quat::Identity(), Vec3(0, 0.05, 0)}, 600);
      const Pose turned{quaternion_exp(Vec3(axis.normalized() * angle)), Vec3(0, 0.05, 0)};
      double torque = 0;
      StepResult result;
      for (int i = 0; i < 4000; ++i) {
        result = step(world, at(turned), {});
        ASSERT_TRUE(result.record.X_WT.is_finite());
        torque = std::max(torque, result.record.coupling_F_T_W.torque.norm());
      }
      EXPECT_LE(torque, scene.coupling.max_torque * (1 + 1e-12));
      if (!massless(GetParam()))  // without mass nothing holds the tool back
        EXPECT_GT(torque, 0.5 * scene.coupling.max_torque) << "at half a turn the spring is wound up";
      EXPECT_LT(rotation_vector(result.record.X_WT.q * turned.q.conjugate()).norm(), 1e-3);
    }
  }
}

TEST_P(EveryResponse, NoTorqueIsExactlyNone) {
  SceneDesc scene = answering(floor_scene({Vec3(0, -0.01, 0)}, 0.05));
  World world = expect(World::build(scene));
  const StepResult free = hold(world, {Quat::Identity(), Vec3(0, 0.05, 0)}, 100);
  EXPECT_EQ(free.record.coupling_F_T_W.torque.norm(), 0);
  // Straight down on a point below the centre: a force, and no torque but rounding.
  for (int i = 0; i < 2000; ++i) {
    const StepResult result = step(world, at({Quat::Identity(), Vec3(0, 0.05 - 2.5e-5 * i, 0)}), {});
    ASSERT_LT(result.record.coupling_F_T_W.torque.norm(), 1e-14);
    ASSERT_TRUE(result.record.X_WT.is_finite());
  }
}

TEST_P(EveryResponse, NumbersAtTheEndsOfTheirRangeAreUsedOrStopTheForce) {
  using Limits = std::numeric_limits<double>;
  const Pose good{Quat::Identity(), Vec3(0, 0.03, 0)};
  struct Case {
    double value;
    bool stops;
  };
  for (const Case& c :
       {Case{Limits::quiet_NaN(), true}, Case{Limits::signaling_NaN(), true}, Case{Limits::infinity(), true},
        Case{-Limits::infinity(), true}, Case{Limits::denorm_min(), false},
        Case{-Limits::denorm_min(), false}, Case{Limits::min() / 2, false}, Case{Limits::epsilon(), false}}) {
    for (int place = 0; place < 7; ++place) {
      World world = expect(World::build(answering(floor_scene(three_feet(), 0.03))));
      hold(world, good, 600);
      DeviceSample sample = at(good);
      if (place < 3)
        sample.X_DH.p[place] += c.value;
      else
        sample.X_DH.q.coeffs()[place - 3] += c.value;
      const StepResult result = step(world, sample, {});
      EXPECT_EQ(result.record.stopped, c.stops) << c.value << " at " << place;
      EXPECT_EQ((result.record.faults & kNotFinite) != 0, c.stops) << c.value << " at " << place;
      for (int i = 0; i < 20; ++i) {
        const StepResult later = step(world, sample, {});
        ASSERT_TRUE(later.record.X_WT.is_finite() && later.command.F_H_D.is_finite());
        ASSERT_TRUE(std::isfinite(later.record.energy_port)) << c.value << " at " << place;
      }
    }
  }
}

// Finite, but the place of no handle: its square overflows, or its energy drowns what the observer has
// booked.
TEST_P(EveryResponse, APoseFarBeyondAnyWorkspaceStopsTheForce) {
  for (const double value : {1.1e3, 1e10, 1e100, 1e155, 1e300, -1e300}) {
    SceneDesc scene = answering(floor_scene(three_feet(), 0.03));
    World world = expect(World::build(scene));
    const Pose good{Quat::Identity(), Vec3(0, 0.03, 0)};
    hold(world, good, 600);
    const StepResult result = hold(world, {Quat::Identity(), Vec3(0, value, 0)}, 200);
    EXPECT_TRUE(result.record.stopped) << value;
    EXPECT_TRUE(result.record.faults & kNotFinite) << value;
    EXPECT_NEAR(result.record.X_WT.p.y(), 0.03, 1e-6) << value;
    const Command acknowledge{Command::Kind::acknowledge};
    step(world, at(good), {&acknowledge, 1});
    const StepResult back = hold(world, good, 1000);
    EXPECT_FALSE(back.record.stopped) << value;
    EXPECT_NEAR(back.record.energy_port, 0, 1e-9) << value;
  }
}

// A hundred metres off is far, and a place: limited, and forgotten when the handle is back.
TEST_P(EveryResponse, AJumpAcrossTheRoomIsLimited) {
  SceneDesc scene = answering(floor_scene(three_feet(), 0.03));
  World world = expect(World::build(scene));
  const Pose good{Quat::Identity(), Vec3(0, 0.03, 0)};
  hold(world, good, 600);
  std::uint32_t faults = 0;
  for (int i = 0; i < 100; ++i) {
    const StepResult result = step(world, at({Quat::Identity(), Vec3(0, i % 2 == 0 ? 100 : -100, 0)}), {});
    ASSERT_TRUE(result.record.X_WT.is_finite());
    ASSERT_LE(result.command.F_H_D.force.norm(), scene.device.max_force * (1 + 1e-12));
    ASSERT_LT(result.record.depth_max, 2e-3);
    faults |= result.record.faults;
  }
  EXPECT_TRUE(faults & kSlewLimited);
  const StepResult back = hold(world, good, 3000);
  EXPECT_FALSE(back.record.stopped);
  EXPECT_LT((back.record.X_WT.p - good.p).norm(), 1e-4);
}

}  // namespace
}  // namespace fulcrum::test
