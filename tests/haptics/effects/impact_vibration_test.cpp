// One impact at a time, and many, without a scene. The truth: W = A v g(t) (n; p x n), tau = A v g(t) p x n,
// with g(t) = sin(2 pi f t) e^(-d t) from the tick of the impact on.

#include "haptics/effects/impact_vibration/impact_vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const ImpactMaterial kSoft{"soft", 0.01, 5, 40};  // far below every cap

ImpactSurroundings around() {
  return {.tick_s = kTick,
          .reach = 0.3,
          .mapping = {},
          .largest_force = 1.6,
          .largest_torque = 0.06,
          .highest_Hz = 400};
}

ImpactVibrationDesc desc(const ImpactMaterial& material = kSoft) {
  ImpactVibrationDesc desc;
  desc.materials = {material};
  return desc;
}

// Faded in: the first 20 ms of a run.
ImpactVibration effect(const ImpactVibrationDesc& d, const ImpactSurroundings& a = around()) {
  ImpactVibration made(d, a);
  for (int i = 0; i < 20; ++i) made.process({}, Vec3::Zero());
  return made;
}

Impact blow(const Vec3& p, const Vec3& n, double speed) {
  return {.p_W = p, .nhat_W = n.normalized(), .speed = speed, .object = 0};
}

Vec3 somewhere(SplitMix& random) {
  return {random.normal(), random.normal(), random.normal()};
}

TEST(ImpactVibration, BeginsInTheNextTickAndIsTheClosedForm) {
  ImpactVibration made = effect(desc());
  const Vec3 p(0.12, 0.02, 0), n(0, 1, 0);
  const Impact impact = blow(p, n, 0.2);
  EXPECT_TRUE(made.process({&impact, 1}, Vec3::Zero()).is_zero());
  const double f = 12 + 28 * (1 - p.norm() / 0.3), w = 2 * std::numbers::pi * f;
  EXPECT_NEAR(made.record().frequency_Hz, f, 1e-12);
  EXPECT_NEAR(made.record().radius, p.norm(), 1e-15);
  for (int i = 1; i < 1300; ++i) {
    const Wrench F = made.process({}, Vec3::Zero());
    const double g = std::exp(-5 * i * kTick) * std::sin(w * i * kTick);
    ASSERT_NEAR((F.force - 0.01 * 0.2 * g * n).norm(), 0, 1e-15) << i;
    ASSERT_NEAR((F.torque - 0.01 * 0.2 * g * p.cross(n)).norm(), 0, 1e-16) << i;
    if (i == 1) EXPECT_GT(F.torque.norm(), 0);
  }
}

// Anywhere, for a device that stands anyhow: the axis is e_r x n, and 5 degrees part torque from force.
TEST(ImpactVibration, AxisIsAcrossLeverAndNormal) {
  SplitMix random(5);
  for (const ImpactRender render : {ImpactRender::wrench, ImpactRender::torque}) {
    int parallel = 0;
    for (int i = 0; i < 2000; ++i) {
      ImpactVibrationDesc d = desc();
      d.render = render;
      ImpactSurroundings a = around();
      a.mapping.X_WD.q = quaternion_exp(somewhere(random));
      a.mapping.force_scale = 0.5;
      ImpactVibration made = effect(d, a);
      const Vec3 p_WH = somewhere(random), n = somewhere(random).normalized();
      // Half of them within 10 degrees of the normal, on either side of it.
      Vec3 e = somewhere(random).normalized();
      if (i % 2 == 0) {
        const Vec3 across = n.unitOrthogonal();
        const double angle = 10 * kDegree * random.uniform();
        e = (i % 4 == 0 ? 1 : -1) * (std::cos(angle) * n + std::sin(angle) * across);
      }
      const double r = 0.02 + 0.25 * random.uniform();
      const Impact impact = blow(p_WH + r * e, n, 0.3);
      made.process({&impact, 1}, p_WH);
      Wrench F_W;
      for (int k = 0; k < 5; ++k) F_W = made.process({}, p_WH);
      F_W = {a.mapping.X_WD.q * F_W.force, a.mapping.X_WD.q * F_W.torque};
      const double between = std::asin(std::min(1.0, e.cross(n).norm()));
      if (between < 5 * kDegree) {
        ++parallel;
        EXPECT_TRUE(F_W.torque.isZero(0));
        EXPECT_NEAR(F_W.force.normalized().dot(n), 1, 1e-9);
        EXPECT_EQ(made.record().axis_W, Vec3::Zero());
        continue;
      }
      const Vec3 axis = e.cross(n).normalized();
      EXPECT_LT(std::acos(std::min(1.0, F_W.torque.normalized().dot(axis))), 0.01 * kDegree);
      EXPECT_NEAR(made.record().axis_W.dot(axis), 1, 1e-9);
      EXPECT_EQ(F_W.force.isZero(0), render == ImpactRender::torque);
      EXPECT_NEAR(made.record().amplitude_D.torque.norm(), 0.5 * 0.01 * 0.3 * r * e.cross(n).norm(), 1e-12);
    }
    EXPECT_GT(parallel, 100);
  }
}

TEST(ImpactVibration, NoLeverNoNumberAndNoSpeedAreHarmless) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ImpactRender render : {ImpactRender::wrench, ImpactRender::torque}) {
    for (const DistanceModel distance : {DistanceModel::beam, DistanceModel::sinusoid}) {
      ImpactVibrationDesc d = desc();
      d.render = render;
      d.distance = distance;
      ImpactVibration made = effect(d);
      const Impact at_hand = blow(Vec3::Zero(), Vec3::UnitY(), 0.2);
      made.process({&at_hand, 1}, Vec3::Zero());
      EXPECT_EQ(made.record().voices, 1) << "felt as a force";
      EXPECT_GT(made.process({}, Vec3::Zero()).force.y(), 0);
      const Impact broken[] = {
          {.p_W = Vec3::Constant(nan), .nhat_W = Vec3::UnitY(), .speed = 0.2, .object = 0},
          {.p_W = Vec3::UnitX(), .nhat_W = Vec3::Constant(nan), .speed = 0.2, .object = 0},
          {.p_W = Vec3::UnitX(), .nhat_W = Vec3::UnitY(), .speed = nan, .object = 0},
          {.p_W = Vec3::UnitX(), .nhat_W = Vec3::UnitY(), .speed = 0, .object = 0},
          {.p_W = Vec3::UnitX(), .nhat_W = Vec3::Zero(), .speed = 0.2, .object = 0}};
      made.process(broken, Vec3::Zero());
      EXPECT_EQ(made.record().voices, 1);
      for (int i = 0; i < 100; ++i) ASSERT_TRUE(made.process({}, Vec3::Zero()).is_finite());
    }
  }
}

// 0.02 rad of a hand of 1 N m/rad, its force at 0.12 m; half of what a small device may have.
TEST(ImpactVibration, AHardBlowIsNoStrongerThanPublished) {
  const auto amplitude = [](const ImpactSurroundings& a, const Vec3& p, double stiffness = 1) {
    ImpactVibrationDesc d = desc(ImpactMaterial());
    d.hand_stiffness = stiffness;
    ImpactVibration made = effect(d, a);
    const Impact impact = blow(p, Vec3::UnitY(), 10);
    made.process({&impact, 1}, Vec3::Zero());
    return made.record().amplitude_D;
  };
  EXPECT_NEAR(amplitude(around(), Vec3(0.24, 0, 0)).torque.norm(), 0.02, 1e-12);
  EXPECT_NEAR(amplitude(around(), Vec3(0.24, 0, 0), 0.5).torque.norm(), 0.01, 1e-12);
  EXPECT_NEAR(amplitude(around(), Vec3(0.06, 0, 0)).force.norm(), 0.02 / 0.12, 1e-12);
  ImpactSurroundings small = around();
  small.largest_torque = 0.01;
  EXPECT_NEAR(amplitude(small, Vec3(0.24, 0, 0)).torque.norm(), 0.005, 1e-12);
  small.largest_torque = 0;
  EXPECT_EQ(amplitude(small, Vec3(0.24, 0, 0)).torque, Vec3::Zero());
  EXPECT_NEAR(amplitude(small, Vec3(0.24, 0, 0)).force.norm(), 0.02 / 0.12, 1e-12);
}

TEST(ImpactVibration, EachObjectSoundsAsItsMaterial) {
  ImpactVibrationDesc d = desc();
  d.materials = {{"a", 0.01, 5, 40}, {"b", 0.02, 5, 20}};
  for (const std::int32_t object : {0, 1, 7, -1}) {
    ImpactVibration made = effect(d);
    Impact impact = blow(Vec3(0.3, 0, 0), Vec3::UnitY(), 0.1);
    impact.object = object;
    made.process({&impact, 1}, Vec3::Zero());
    const bool second = object == 1 || object == 7;
    EXPECT_NEAR(made.record().amplitude_D.force.y(), second ? 0.002 : 0.001, 1e-15) << object;
  }
}

TEST(ImpactVibration, WhatCannotBeRenderedIsLeftOut) {
  ImpactVibrationDesc d = desc();
  d.distance = DistanceModel::beam;
  ImpactSurroundings a = around();
  a.highest_Hz = 100;
  ImpactVibration made = effect(d, a);
  const Impact impact = blow(Vec3(0.3, 0, 0), Vec3::UnitY(), 0.1);
  made.process({&impact, 1}, Vec3::Zero());
  // Of 40, 251 and 702 Hz the first is left.
  const double w = 2 * std::numbers::pi * 40;
  for (int i = 1; i < 100; ++i) {
    ASSERT_NEAR(made.process({}, Vec3::Zero()).force.y(),
                0.001 * std::exp(-5 * i * kTick) * std::sin(w * i * kTick), 1e-12);
  }
  a.highest_Hz = 30;
  ImpactVibration silent = effect(d, a);
  silent.process({&impact, 1}, Vec3::Zero());
  EXPECT_EQ(silent.record().voices, 0);
  EXPECT_EQ(highest_vibration(500, 1e-3), 400.0);
  EXPECT_EQ(highest_vibration(150, 1e-3), 150.0);
}

TEST(ImpactVibration, FiveImpactsWithinTwentyMillisecondsAllSound) {
  ImpactVibration made = effect(desc());
  std::vector<ImpactVibration> alone;
  for (int i = 0; i < 5; ++i) alone.push_back(effect(desc()));
  for (int tick = 0; tick < 400; ++tick) {
    Wrench sum;
    for (int i = 0; i < 5; ++i) {
      const Impact impact = blow(Vec3(0.05 * i + 0.05, 0.01, 0), Vec3::UnitY(), 0.1 + 0.02 * i);
      const bool now = tick == 4 * i;
      sum += alone[static_cast<std::size_t>(i)].process({&impact, now ? 1u : 0u}, Vec3::Zero());
    }
    const Impact impact =
        blow(Vec3(0.05 * (tick / 4) + 0.05, 0.01, 0), Vec3::UnitY(), 0.1 + 0.02 * (tick / 4));
    const bool now = tick % 4 == 0 && tick < 20;
    const Wrench F = made.process({&impact, now ? 1u : 0u}, Vec3::Zero());
    ASSERT_NEAR((F.force - sum.force).norm() + (F.torque - sum.torque).norm(), 0, 1e-15);
    if (tick >= 16 && tick < 100) EXPECT_EQ(made.record().voices, 5);
  }
  EXPECT_EQ(made.record().dropped, 0);
}

TEST(ImpactVibration, OneMoreDropsTheWeakestAndIsCounted) {
  ImpactVibrationDesc d = desc();
  d.voices = 3;
  ImpactVibration made = effect(d);
  std::vector<Impact> impacts;
  for (const double speed : {0.3, 0.1, 0.2}) impacts.push_back(blow(Vec3(0.1, 0, 0), Vec3::UnitY(), speed));
  made.process(impacts, Vec3::Zero());
  EXPECT_EQ(made.record().voices, 3);
  const auto strike = [&made](double speed) {
    const Impact impact = blow(Vec3(0.1, 0, 0), Vec3::UnitY(), speed);
    return made.process({&impact, 1}, Vec3::Zero());
  };
  strike(0.05);  // weaker than all
  EXPECT_EQ(made.record().dropped, 1);
  EXPECT_NEAR(made.record().amplitude_D.force.y(), 0.01 * 0.2, 1e-15) << "what was dropped is not the newest";
  strike(0.25);  // instead of 0.1
  EXPECT_EQ(made.record().dropped, 2);
  EXPECT_EQ(made.record().voices, 3);
  // 0.3 and 0.2, two ticks older than 0.25.
  const double w = 2 * std::numbers::pi * made.record().frequency_Hz;
  const auto g = [w](int n) { return std::exp(-5 * n * kTick) * std::sin(w * n * kTick); };
  EXPECT_NEAR(made.process({}, Vec3::Zero()).force.y(), 0.01 * ((0.3 + 0.2) * g(3) + 0.25 * g(1)), 1e-15);
  // What is left counts: 0.3 has faded below 0.1 after log(3) / 5 s, and more.
  for (int i = 0; i < 260; ++i) made.process({}, Vec3::Zero());
  strike(0.1);
  EXPECT_EQ(made.record().dropped, 3);
  EXPECT_NEAR(made.record().amplitude_D.force.y(), 0.01 * 0.1, 1e-15);
}

TEST(ImpactVibration, AVoiceEndsAtAThousandth) {
  ImpactVibration made = effect(desc());
  const Impact impact = blow(Vec3(0.1, 0, 0), Vec3::UnitY(), 0.2);
  made.process({&impact, 1}, Vec3::Zero());
  int ticks = 0;
  while (made.record().voices == 1 && ticks < 5000) {
    made.process({}, Vec3::Zero());
    ++ticks;
  }
  EXPECT_NEAR(ticks * kTick, std::log(1000.0) / 5, 2 * kTick);
  EXPECT_TRUE(made.process({}, Vec3::Zero()).is_zero());
}

TEST(ImpactVibration, IsSwitchedWithoutAClick) {
  ImpactVibration made = effect(desc());
  const Impact impact = blow(Vec3(0.1, 0, 0), Vec3::UnitY(), 0.2);
  made.process({&impact, 1}, Vec3::Zero());
  Wrench last = made.process({}, Vec3::Zero());
  made.apply({Command::Kind::impact_gain, 0});
  for (int i = 0; i < 21; ++i) {
    const Wrench next = made.process({}, Vec3::Zero());
    // No faster than the tone itself, and a twentieth of the amplitude.
    EXPECT_LT((next.force - last.force).norm(), 0.002 * (2 * std::numbers::pi * 40 * kTick + 0.05));
    last = next;
  }
  EXPECT_TRUE(last.is_zero());
  made.process({&impact, 1}, Vec3::Zero());
  EXPECT_EQ(made.record().voices, 1) << "none begins while it is off";
}

}  // namespace
}  // namespace fulcrum::test
