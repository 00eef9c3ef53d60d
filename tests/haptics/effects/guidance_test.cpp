// Reference: distances and forces on straight ways, by hand; the work of a hand, by sums; and the border of
// stability by a mass that is integrated here, under a force that is held from tick to tick.

#include "haptics/effects/guidance/guidance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "haptics/effects/guidance/guidance_effect.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/faults.h"
#include "tests/haptics/extremes/closed_loop.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr Command kGuidanceOn{Command::Kind::guidance_gain, 1}, kGuidanceOff{Command::Kind::guidance_gain, 0};
constexpr int kRampedIn = 501;  // ticks, in which it has ramped in

// Of round figures, and linear.
DeviceDesc frictionless_device() {
  DeviceDesc device;
  device.max_force = 8;
  device.handle_mass = 0.1;
  device.handle_weight = 0;
  device.damping = 0.5;
  device.friction = device.angular_friction = 0;
  device.encoder_step = device.encoder_step_rad = 0;
  return device;
}

GuidancePose guided_pose(double time, const Vec3& p, bool rests = false, const Quat& q = Quat::Identity()) {
  return {time, {q, p}, rests};
}

// 0.1 m along x in 2 s, then 0.1 m along y in 1 s.
std::vector<GuidancePose> round_a_corner() {
  return {guided_pose(0, {0, 0, 0}), guided_pose(2, {0.1, 0, 0}), guided_pose(3, {0.1, 0.1, 0})};
}

// To a dead end at x = 0.1 m and back.
std::vector<GuidancePose> to_and_fro() {
  return {guided_pose(0, {0, 0, 0}), guided_pose(1, {0.1, 0, 0}), guided_pose(2, {0, 0, 0}),
          guided_pose(3, {0, 0.1, 0})};
}

GuidanceDesc guidance_along(std::vector<GuidancePose> way) {
  GuidanceDesc desc;
  desc.way = std::move(way);
  desc.dead_band = 2e-3;
  desc.window = 20e-3;
  desc.stiffness = 200;
  desc.max_force = 1;
  return desc;
}

// A handle at T.
Guidance guidance_on(const GuidanceDesc& desc, const DeviceDesc& device = frictionless_device()) {
  return Guidance(desc, {.device = device});
}

Vec3 led(Guidance& guidance, const Vec3& p, int ticks = 1) {
  Vec3 force = Vec3::Zero();
  for (int i = 0; i < ticks; ++i) force = guidance.process({.p_WH = p});
  return force;
}

// Switched on, ramped in, at rest at p.
Guidance led_at(const GuidanceDesc& desc, const Vec3& p) {
  Guidance guidance = guidance_on(desc);
  guidance.apply(kGuidanceOn);
  led(guidance, p, kRampedIn + 20);
  return guidance;
}

TEST(Guidance, PullsByStiffnessTimesWhatIsBeyondTheDeadBand) {
  for (const double d : {0.0, 1e-3, 2e-3, 3e-3, 4.5e-3, 6.9e-3, 7e-3, 8e-3, 0.5}) {
    Guidance guidance = led_at(guidance_along(round_a_corner()), {0.04, 0, d});
    const double expected = std::clamp(200 * (d - 2e-3), 0.0, 1.0);
    EXPECT_NEAR((led(guidance, {0.04, 0, d}) - Vec3(0, 0, -expected)).norm(), 0, 1e-12) << d;
    EXPECT_NEAR(guidance.record().distance, d, 1e-15);
    EXPECT_NEAR(guidance.record().time, 0.8, 1e-12);
  }
}

// 2.5 m in the scene for one at the device, which stands turned.
TEST(Guidance, PullsByWhatTheDistanceIsAtTheDevice) {
  MappingDesc mapping;
  mapping.X_WD = {quaternion_exp(Vec3(0.4, -1.1, 0.3)), Vec3(0.3, 0.1, 0)};
  mapping.position_scale = 2.5;
  mapping.force_scale = 0.4;
  const DeviceDesc device = frictionless_device();
  Guidance guidance(guidance_along(round_a_corner()), {.mapping = mapping, .device = device});
  guidance.apply(kGuidanceOn);
  const Vec3 force_D = led(guidance, {0.04, 0, 7e-3}, kRampedIn + 20);
  const Vec3 expected = 200 * 5e-3 / 2.5 * (mapping.X_WD.q.conjugate() * Vec3(0, 0, -1));
  EXPECT_NEAR((force_D - expected).norm(), 0, 1e-12);
}

TEST(Guidance, ThePlaceOnTheWayNeverGoesBack) {
  Guidance guidance = led_at(guidance_along(round_a_corner()), {0.05, 0, 0});
  EXPECT_EQ(led(guidance, {0.05, 1e-3, 0}), Vec3::Zero());
  const double reached = guidance.record().time;
  EXPECT_NEAR(reached, 1, 1e-12);
  EXPECT_EQ(led(guidance, {0.049, 0, 0}), Vec3::Zero());
  EXPECT_NEAR((led(guidance, {0.047, 0, 0}) - Vec3(0.2, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((led(guidance, {-0.5, 0, 0}) - Vec3(1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(guidance.record().time, reached);
}

TEST(Guidance, AJumpOfTheHandleMovesItsPlaceByNoMoreThanTheWindow) {
  Guidance guidance = led_at(guidance_along(round_a_corner()), {0.05, 0, 0});
  led(guidance, {0.1, 0.1, 0});  // the end
  EXPECT_NEAR(guidance.record().time, 2 * 0.07 / 0.1, 1e-9);
  led(guidance, {0.1, 0.1, 0});
  EXPECT_NEAR(guidance.record().time, 2 * 0.09 / 0.1, 1e-9);
  led(guidance, {0.1, 0.1, 0}, 20);
  EXPECT_NEAR(guidance.record().time, 3, 1e-12);
}

// In as far as 3 mm before the end, where something stands in the way, and out again; 1 mm beside it.
TEST(Guidance, AWayBackIsNotTakenBeforeItsTurn) {
  Guidance guidance = led_at(guidance_along(to_and_fro()), {0.05, 1e-3, 0});
  for (double x = 0.05; x < 0.097; x += 1e-4) {
    EXPECT_EQ(led(guidance, {x, 1e-3, 0}), Vec3::Zero());
    ASSERT_NEAR(guidance.record().time, x / 0.1, 1e-9) << "it goes in";
  }
  for (double x = 0.097; x > 0.02; x -= 1e-4) EXPECT_EQ(led(guidance, {x, 1e-3, 0}), Vec3::Zero()) << x;
  EXPECT_NEAR(guidance.record().time, 1 + 0.08 / 0.1, 1e-3);
}

TEST(Guidance, ComesAndGoesWithinHalfASecond) {
  Guidance guidance = guidance_on(guidance_along(round_a_corner()));
  const Vec3 p(0.04, 0, 5e-3);
  EXPECT_EQ(led(guidance, p, 100), Vec3::Zero());
  EXPECT_EQ(guidance.record().level, 0);
  guidance.apply(kGuidanceOn);
  double before = 0;
  for (int i = 0; i < kRampedIn; ++i) {
    const double pull = led(guidance, p).norm();
    ASSERT_LE(pull - before, 0.6 / 500 + 1e-12);
    before = pull;
  }
  EXPECT_NEAR(before, 0.6, 1e-12);
  guidance.apply({Command::Kind::guidance_gain, 0.5});
  EXPECT_NEAR(led(guidance, p, kRampedIn).norm(), 0.3, 1e-12);
  guidance.apply(kGuidanceOff);
  EXPECT_NEAR(led(guidance, p, 125).norm(), 0.15, 1e-3);
  EXPECT_EQ(led(guidance, p, 130), Vec3::Zero());
  EXPECT_EQ(guidance.record().distance, 0);
  EXPECT_EQ(guidance.record().level, 0);
}

TEST(Guidance, AClutchedHandFeelsNothing) {
  Guidance guidance = led_at(guidance_along(round_a_corner()), {0.04, 0, 5e-3});
  EXPECT_EQ(guidance.process({.p_WH = {0.04, 0, 5e-3}, .engaged = false}), Vec3::Zero());
  EXPECT_NEAR(led(guidance, {0.04, 0, 5e-3}).norm(), 0.6 / 500, 1e-12);
}

// Half a second further on, evenly along each leg and over the corner; the rotation goes with it.
TEST(Guidance, TheExpertsToolIsHalfASecondAhead) {
  std::vector<GuidancePose> way = round_a_corner();
  way[1].X_WT.q = quaternion_exp(Vec3(0, 0.8, 0));
  way[2].X_WT.q = way[1].X_WT.q;
  const auto shown = [&](const Vec3& p) {
    Guidance guidance = led_at(guidance_along(way), p);
    return guidance.record().X_WT_ahead;
  };
  EXPECT_NEAR((shown({0.02, 0, 0}).p - Vec3(0.045, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((rotation_vector(shown({0.02, 0, 0}).q) - Vec3(0, 0.36, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((shown({0.09, 0, 0}).p - Vec3(0.1, 0.03, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((shown({0.1, 0.09, 0}).p - Vec3(0.1, 0.1, 0)).norm(), 0, 1e-9);  // it stays at the end
}

// The handle lies 0.1 m from T and goes round while T rests: on its circle nothing is felt.
TEST(Guidance, TheWayIsThatOfTheHandle) {
  const Vec3 p_TH(0, 0, 0.1);
  const DeviceDesc device = frictionless_device();
  GuidanceDesc desc = guidance_along(
      {guided_pose(0, {0, 0, 0}), guided_pose(2, {0, 0, 0}, true, quaternion_exp({0, 1.2, 0}))});
  desc.dead_band = 0.15e-3;  // pieces of 0.1 rad lie within 0.13 mm of the circle
  Guidance guidance(desc, {.p_TH = p_TH, .device = device});
  guidance.apply(kGuidanceOn);
  led(guidance, p_TH, kRampedIn + 20);
  for (double turned = 0; turned <= 1.2; turned += 0.01) {
    EXPECT_EQ(led(guidance, quaternion_exp(Vec3(0, turned, 0)) * p_TH), Vec3::Zero()) << turned;
    EXPECT_NEAR(guidance.record().time, 2 * turned / 1.2, 0.01);
  }
}

// Four times through the same place: it begins after the place of rest that was passed last.
TEST(Guidance, BeginsWhereTheTaskStands) {
  const auto time_at = [](int rests_passed) {
    Guidance guidance = guidance_on(guidance_along(
        {guided_pose(0, {0, 0, 0}, true), guided_pose(1, {0.1, 0, 0}, true), guided_pose(2, {0, 0, 0}),
         guided_pose(3, {0, 0.1, 0}, true), guided_pose(4, {0, 0, 0}), guided_pose(5, {0, 0, 0.1}, true),
         guided_pose(6, {0, 0, 0})}));
    const Vec3 rests[] = {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
    for (int i = 0; i < rests_passed; ++i) led(guidance, rests[i] + Vec3(0.01, 0.01, 0));
    led(guidance, Vec3::Zero());
    EXPECT_EQ(guidance.record().level, 0);
    guidance.apply(kGuidanceOn);
    led(guidance, Vec3::Zero(), 10);
    return guidance.record().time;
  };
  EXPECT_EQ(time_at(0), 0);
  EXPECT_EQ(time_at(1), 2);
  EXPECT_EQ(time_at(2), 4);
  EXPECT_EQ(time_at(3), 6);
}

// Switched on in the middle of a long way it looks through 16 pieces a tick, and pulls once it knows where.
TEST(Guidance, FindsItsPlaceInSteps) {
  std::vector<GuidancePose> way;
  for (int i = 0; i <= 1000; ++i)
    way.push_back(guided_pose(0.1 * i, {1e-3 * i, 0.01 * std::sin(0.02 * i), 0}));
  Guidance guidance = guidance_on(guidance_along(way));
  ASSERT_EQ(guidance.way().pieces(), 1000u);
  guidance.apply(kGuidanceOn);
  const Vec3 p(0.7005, 0.01 * std::sin(0.02 * 700.5), 1e-3);
  led(guidance, p, 61);
  EXPECT_EQ(guidance.record().level, 0);
  led(guidance, p, 5);
  EXPECT_GT(guidance.record().level, 0);
  EXPECT_NEAR(guidance.record().time, 70.05, 1e-3);
}

// A hand that goes anywhere: its place may only come nearer while the handle rests.
TEST(Guidance, APlaceThatMovesNeverWindsTheSpring) {
  SplitMix random(3);
  Guidance guidance = led_at(guidance_along(to_and_fro()), {0, 0, 0});
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 20000; ++i) {
    const Vec3 step(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    p = 0.999 * p + 4e-3 * step + Vec3(2e-5, 0, 0);
    led(guidance, p);
    const double distance = guidance.record().distance, time = guidance.record().time;
    led(guidance, p);
    ASSERT_LE(guidance.record().distance, distance) << i;
    ASSERT_GE(guidance.record().time, time) << i;
  }
}

// J, that a hand has put in beyond what stored() tells, at its least; along a round of the way and about it,
// switched on and off on the way.
double put_in_at_least(double step) {
  Guidance guidance = guidance_on(guidance_along(round_a_corner()));
  guidance.apply(kGuidanceOn);
  double J = 0, least = 0;
  Vec3 before = Vec3::Zero(), force = Vec3::Zero();
  const int ticks = static_cast<int>(1 / step);
  for (int i = 0; i < ticks; ++i) {
    const double a = 2 * std::numbers::pi * i / ticks;
    const Vec3 p(0.06 * (1 - std::cos(a)), 0.04 * std::sin(3 * a) + 0.02, 0.02 * std::sin(5 * a));
    J -= force.dot(p - before);
    if (i == ticks / 2) guidance.apply(kGuidanceOff);
    if (i == 3 * ticks / 4) guidance.apply(kGuidanceOn);
    force = guidance.process({.p_WH = p});  // at a speed of 0 for the damper: the spring alone
    before = p;
    least = std::min(least, J - guidance.stored());
  }
  return least;
}

// A held spring makes K |step|^2 / 2 in each tick, which falls with the step; nothing else is made.
TEST(Guidance, GivesOutNoMoreThanItsRampLetIn) {
  const double coarse = put_in_at_least(1.0 / 16000), fine = put_in_at_least(1.0 / 64000);
  EXPECT_LT(coarse, 0);
  EXPECT_GT(fine, 0.3 * coarse);
  EXPECT_GT(put_in_at_least(1.0 / 1024000), -1e-5);
}

// m, how far a handle still swings that was 1 um from rest, pressed by 0.5 N away from a way of one point.
// Exactly, over each tick in which the force is held, `late` ticks after it was found.
double led_swing(const DeviceDesc& device, double stiffness, std::size_t late) {
  GuidanceDesc desc = guidance_along({guided_pose(0, {0, 0, 0})});
  desc.stiffness = stiffness;
  desc.max_force = 4;
  Guidance guidance = guidance_on(desc, device);
  guidance.apply(kGuidanceOn);
  const double rest = desc.dead_band + 0.5 / stiffness, m = device.handle_mass, b = device.damping;
  led(guidance, {rest, 0, 0}, kRampedIn + 20);
  const double e = std::exp(-b / m * kTick);
  double x = rest + 1e-6, v = 0, swing = 0, before = x;
  std::vector<double> waiting(late, -0.5);
  for (int i = 0; i < 8000; ++i) {
    waiting.push_back(guidance.process({.p_WH = {x, 0, 0}, .per_tick_D = {x - before, 0, 0}}).x());
    before = x;
    const double settled = (0.5 + waiting.front()) / b;  // m/s
    waiting.erase(waiting.begin());
    x += settled * kTick + (v - settled) * m / b * (1 - e);
    v = settled + (v - settled) * e;
    if (i >= 7500) swing = std::max(swing, std::abs(x - rest));
  }
  return swing;
}

TEST(Guidance, IsStableUpToTheLimitAndNoFurther) {
  for (const double mass : {0.05, 0.1, 0.3}) {
    for (const bool late : {false, true}) {
      DeviceDesc device = frictionless_device();
      device.handle_mass = mass;
      if (late) device.sample_rate_Hz = 1000;
      const double limit = DampedSpring::limit(device, kTick);
      EXPECT_LT(led_swing(device, 0.9 * limit, late ? 1 : 0), 0.5e-6) << mass << late;
      EXPECT_GT(led_swing(device, 1.1 * limit, late ? 1 : 0), 2e-6) << mass << late;
    }
  }
}

TEST(Guidance, TheStiffnessSuitsTheDevice) {
  const DeviceDesc device = frictionless_device();
  const auto chosen = [&](double dead_band) {
    GuidanceDesc desc{.way = round_a_corner(), .dead_band = dead_band};
    return guidance_on(desc, device).spring()->stiffness();
  };
  EXPECT_NEAR(chosen(2e-3), 0.2 * 8 / (5 * 2e-3), 1e-9);  // a fifth of 8 N, five dead bands beyond it
  const double limit = DampedSpring::limit(device, kTick);
  EXPECT_NEAR(chosen(1e-5), 0.25 * limit, 1e-9 * limit);
}

TEST(Guidance, AWayOfOnePointOrOfNoLengthPullsToThere) {
  for (const auto& way : {std::vector{guided_pose(0, {0.1, 0, 0})},
                          std::vector{guided_pose(0, {0.1, 0, 0}, true), guided_pose(0, {0.1, 0, 0}, true)},
                          std::vector{guided_pose(0, {0.1, 0, 0}), guided_pose(5, {0.1, 0, 0}, true),
                                      guided_pose(5, {0.1, 0, 0})}}) {
    Guidance guidance = led_at(guidance_along(way), {0.1, 5e-3, 0});
    EXPECT_NEAR((led(guidance, {0.1, 5e-3, 0}) - Vec3(0, -0.6, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(guidance.record().X_WT_ahead.p, Vec3(0.1, 0, 0));
    EXPECT_TRUE(std::isfinite(guidance.stored()));
  }
}

TEST(Guidance, MirroredItPullsAsTheMirrorImage) {
  GuidanceDesc right =
      guidance_along({guided_pose(0, {0, 0, 0}),
                      guided_pose(2, {0.1, 0.02, 0.03}, true, quaternion_exp(Vec3(0.3, 0.5, -0.2)))});
  GuidanceDesc left = right;
  mirror(left);
  const DeviceDesc device = frictionless_device();
  Vec3 p_TH(0.02, -0.01, 0.05), p(0.05, 0.02, 0.07);
  Guidance a(right, {.p_TH = p_TH, .device = device});
  mirror(p_TH);
  Guidance b(left, {.p_TH = p_TH, .device = device});
  a.apply(kGuidanceOn);
  b.apply(kGuidanceOn);
  for (int i = 0; i < 600; ++i) {
    p += Vec3(5e-5, 1e-5, -2e-5);
    Vec3 mirrored = p;
    mirror(mirrored);
    Vec3 force = led(a, p);
    mirror(force);
    ASSERT_NEAR((led(b, mirrored) - force).norm(), 0, 1e-14) << i;
    Pose ahead = a.record().X_WT_ahead;
    mirror(ahead);
    ASSERT_NEAR((b.record().X_WT_ahead.p - ahead.p).norm(), 0, 1e-14);
    ASSERT_NEAR((b.record().X_WT_ahead.q.coeffs() - ahead.q.coeffs()).norm(), 0, 1e-14);
  }
}

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
