// Reference: distances and forces on straight ways, by hand; the work of a hand, by sums; and the border of
// stability by a mass that is integrated here, under a force that is held from tick to tick.

#include "haptics/effects/guidance/guidance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "tests/haptics/effects/guided.h"
#include "tests/haptics/effects/handle_springs.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

// To a dead end at x = 0.1 m and back.
std::vector<GuidancePose> to_and_fro() {
  return {guided_pose(0, {0, 0, 0}), guided_pose(1, {0.1, 0, 0}), guided_pose(2, {0, 0, 0}),
          guided_pose(3, {0, 0.1, 0})};
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

// m, pressed by 0.5 N away from a way of one point.
double led_swing(const DeviceDesc& device, double stiffness, std::size_t late) {
  GuidanceDesc desc = guidance_along({guided_pose(0, {0, 0, 0})});
  desc.stiffness = stiffness;
  desc.max_force = 4;
  Guidance guidance = guidance_on(desc, device);
  guidance.apply(kGuidanceOn);
  const double rest = desc.dead_band + 0.5 / stiffness;
  led(guidance, {rest, 0, 0}, kRampedIn + 20);
  return swing_left(device, {.rest = rest, .press = 0.5}, late, [&](double x, double per_tick) {
    return guidance.process({.p_WH = {x, 0, 0}, .per_tick_D = {per_tick, 0, 0}}).x();
  });
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

}  // namespace
}  // namespace fulcrum::test
