// Reference: the slope of a sine, by hand. In a loop: a spring that is held between ticks stands still while
// its stiffness is below twice the damping over the tick, and a World that slides feels the ridges' frequency
// and size.

#include "haptics/effects/texture/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>
#include <vector>

#include "tests/haptics/scenes.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr double kPi = std::numbers::pi;

ContactRegion pressed_at(const Vec3& p_W, double force, const Vec3& nhat_W = Vec3::UnitY()) {
  ContactRegion region;
  region.p_W = p_W;
  region.nhat_W = nhat_W;
  region.force_W = force * nhat_W;
  return region;
}

Wrench felt(Texture& texture, const ContactRegion& region, double speed = 0) {
  return texture.process({.regions = {&region, 1}, .v_WH = speed * Vec3::UnitX()});
}

TEST(Texture, IsTheSlopeTimesTheForceThatPresses) {
  Texture texture({.wavelength = 3e-3, .height = 40e-6}, kTick);
  for (const double x : {0.0, 0.4e-3, 0.75e-3, 1.5e-3, 2.2e-3, -7.1e-3}) {
    const double slope = 40e-6 * 2 * kPi / 3e-3 * std::cos(2 * kPi * x / 3e-3);
    EXPECT_NEAR(felt(texture, pressed_at({x, 0.2, 0.3}, 2.5)).force.x(), -2.5 * slope, 1e-15) << x;
  }
}

// A push in the surface, whatever way it lies; and none across ridges that run along the slope of the
// surface.
TEST(Texture, LiesInTheSurface) {
  Texture texture({.direction_W = Vec3(2, 0, 0)}, kTick);
  for (const Vec3& n : {Vec3(0, 1, 0), Vec3(0.6, 0.8, 0), Vec3(0.48, 0.64, 0.6), Vec3(1, 0, 0)}) {
    const Vec3 force = felt(texture, pressed_at(Vec3::Zero(), 1.5, n)).force;
    EXPECT_NEAR(force.dot(n), 0, 1e-15);
    EXPECT_NEAR(force.norm(), 1.5 * texture.steepest() * std::sqrt(1 - n.x() * n.x()), 1e-12);
  }
}

TEST(Texture, EachRegionPushesWhereItIsPressed) {
  Texture texture({.wavelength = 2e-3}, kTick);
  const ContactRegion regions[] = {pressed_at({0, 0, 0.01}, 1), pressed_at({1e-3, 0, -0.01}, 1)};
  const Wrench F = texture.process({.regions = regions});
  EXPECT_NEAR(F.force.x(), 0, 1e-12);  // half a ridge apart: one is pushed on as much as the other back
  EXPECT_NEAR(F.torque.y(), -2 * 0.01 * texture.steepest(), 1e-12);
}

// The work over a closed way, in ticks, falls with the square of the step.
TEST(Texture, GivesBackWhatItTook) {
  const auto work = [](int ticks_per_ridge) {
    Texture texture({}, kTick);
    const double step = texture.desc().wavelength / ticks_per_ridge;
    double J = 0;
    for (int i = 0; i < 3 * ticks_per_ridge; ++i)  // from a crest, so that the ends are alike
      J += felt(texture, pressed_at({(i + 0.25) * step, 0, 0}, 2)).force.x() * step;
    return J;
  };
  EXPECT_NEAR(work(20), 0, 1e-18);
  EXPECT_NEAR(work(7), 0, 1e-18);
}

TEST(Texture, FadesWhereATickWouldSkipRidges) {
  Texture texture({.wavelength = 2e-3}, kTick);
  const ContactRegion region = pressed_at(Vec3::Zero(), 1);
  const double whole = felt(texture, region).force.norm();
  EXPECT_EQ(texture.fastest(), 0.2 * 2e-3 / kTick);
  EXPECT_EQ(felt(texture, region, 0.39).force.norm(), whole);
  EXPECT_NEAR(felt(texture, region, -0.6).force.norm(), 0.5 * whole, 1e-12);
  EXPECT_EQ(felt(texture, region, 0.81).force.norm(), 0);
  EXPECT_EQ(felt(texture, region, 1e300).force.norm(), 0);
}

TEST(Texture, NothingIsFeltOffClutchedOrWhereNothingPresses) {
  Texture texture({}, kTick);
  const ContactRegion region = pressed_at(Vec3::Zero(), 1), leaving = pressed_at(Vec3::Zero(), -1);
  EXPECT_FALSE(texture.process({.regions = {&region, 1}}).is_zero());
  EXPECT_TRUE(texture.process({.regions = {&leaving, 1}}).is_zero());
  EXPECT_TRUE(texture.process({}).is_zero());
  EXPECT_TRUE(texture.process({.regions = {&region, 1}, .engaged = false}).is_zero());
  texture.apply({Command::Kind::texture_gain, 0});
  EXPECT_TRUE(texture.process({.regions = {&region, 1}}).is_zero());
  texture.apply({Command::Kind::texture_gain, 0.5});
  EXPECT_NEAR(texture.process({.regions = {&region, 1}}).force.norm(), 0.5 * texture.steepest(), 1e-12);
}

// A mass with a damper slides freely across ridges pressed by a constant force, from just beside a trough.
// The force is held over the tick, by the position at its beginning: to first order of w T that takes K T / 2
// from the damping, so that the swing goes as exp(-(b - K T / 2) t / 2 m), and the border is K = 2 b / T.
TEST(Texture, StandsStillInATroughUpToTwiceTheDampingOverTheTick) {
  const double mass = 0.2, b = 0.5, pressing = 2;
  const auto swing = [&](double of_border) {
    const double L = 4e-3, K = of_border * 2 * b / kTick;
    const double A = K * L * L / (pressing * 4 * kPi * kPi);
    Texture texture({.wavelength = L, .height = A}, kTick);
    const double trough = 0.75 * L;
    double x = trough + 1e-6, v = 0, late = 0;
    for (int i = 0; i < 4000; ++i) {
      const double f = felt(texture, pressed_at({x, 0, 0}, pressing)).force.x();
      const double e = std::exp(-b / mass * kTick), settled = f / b;  // exactly, over the held tick
      x += settled * kTick + (v - settled) * mass / b * (1 - e);
      v = settled + (v - settled) * e;
      if (i >= 3500) late = std::max(late, std::abs(x - trough));
    }
    return late;
  };
  for (const double of_border : {0.5, 0.9, 1.1, 1.5}) {
    const double rate = -b * (1 - of_border) / (2 * mass), t = of_border < 1 ? 3.5 : 4.0;
    EXPECT_NEAR(std::log(swing(of_border) / 1e-6), rate * t, 0.05 + 0.02 * std::abs(rate * t)) << of_border;
  }
}

SceneDesc textured_scene() {
  SceneDesc desc = floor_scene({Vec3::Zero()}, -0.2e-3);
  desc.contact.response = ContactResponse::constraint;
  desc.device.kinematics = Kinematics::cartesian;
  desc.device.handle_weight = 0;
  desc.texture.emplace();
  return desc;
}

constexpr double kTrough = -0.25, kCrest = 0.25;  // ridges

// Held 0.2 mm below the floor, `from` ridges from where the height is 0 and rises, then along x.
std::vector<TickRecord> slid(const SceneDesc& desc, double speed, double seconds, double from) {
  World world = expect(World::build(desc));
  std::vector<TickRecord> records;
  const int still = 600, ticks = static_cast<int>(seconds / desc.tick_s);
  for (int i = -still; i < ticks; ++i) {
    const double x = -0.02 + from * desc.texture.value_or(TextureDesc()).wavelength;
    const Vec3 p(x + std::max(i, 0) * speed * desc.tick_s, -0.2e-3, 0);
    records.push_back(step(world, at(desc.mapping.handle_in_device({Quat::Identity(), p})), {}).record);
  }
  records.erase(records.begin(), records.begin() + still);
  return records;
}

// N, of the handle's force along x at a frequency.
double amplitude(const std::vector<TickRecord>& records, std::size_t from, double f_Hz) {
  std::complex<double> sum = 0;
  for (std::size_t i = from; i < records.size(); ++i)
    sum +=
        records[i].device_F_H_D.force.x() * std::polar(1.0, -2 * kPi * f_Hz * kTick * static_cast<double>(i));
  return 2 * std::abs(sum) / static_cast<double>(records.size() - from);
}

TEST(TextureInAWorld, IsFeltAtTheSpeedOverTheWavelength) {
  SceneDesc desc = textured_scene();
  desc.device.encoder_step = desc.device.encoder_step_rad = 0;
  const std::vector<TickRecord> records = slid(desc, 0.05, 0.5, kTrough);  // 25 ridges a second
  const double pressing = records.back().contact_F_T_W.force.y();
  ASSERT_GT(pressing, 0.1);
  const double expected = pressing * desc.texture->height * 2 * kPi / desc.texture->wavelength;
  EXPECT_NEAR(amplitude(records, 100, 25), expected, 1e-3 * expected);
  for (const double other_Hz : {12.5, 37.5, 50.0, 75.0, 100.0})
    EXPECT_LT(amplitude(records, 100, other_Hz), 1e-3 * expected) << other_Hz;
}

// A hand that lands on a crest gets back, on its way down, what it never put in: 2 A f_n, 6.3 uJ here. And
// what encoders cannot see of each ridge counts as made. Passivity control brakes for both, which bends the
// ridges a little.
TEST(TextureInAWorld, PassivityControlBendsItALittle) {
  const SceneDesc desc = textured_scene();
  const std::vector<TickRecord> records = slid(desc, 0.05, 0.5, kCrest);
  const double pressing = records.back().contact_F_T_W.force.y();
  const double expected = pressing * desc.texture->height * 2 * kPi / desc.texture->wavelength;
  EXPECT_TRUE(std::ranges::any_of(records, [](const TickRecord& r) { return r.faults & kPassivityControl; }));
  EXPECT_NEAR(amplitude(records, 100, 25), expected, 0.03 * expected);
  for (const double other_Hz : {12.5, 37.5, 50.0, 75.0, 100.0})
    EXPECT_LT(amplitude(records, 100, other_Hz), 0.06 * expected) << other_Hz;
}

TEST(TextureInAWorld, OffLeavesEveryOtherValueAsItIs) {
  SceneDesc off = textured_scene(), none = textured_scene();
  off.texture->gain = 0;
  none.texture.reset();
  const std::vector<TickRecord> a = slid(off, 0.05, 0.2, 0), b = slid(none, 0.05, 0.2, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].device_F_H_D.force, b[i].device_F_H_D.force) << i;
    ASSERT_EQ(a[i].X_WT.p, b[i].X_WT.p) << i;
    ASSERT_EQ(a[i].energy_port, b[i].energy_port) << i;
    ASSERT_TRUE(a[i].texture && !b[i].texture);
  }
}

TEST(TextureInAWorld, AnyRidgesStayWithinTheDevicesForce) {
  for (const double height : {1e-5, 1e-3, 1.0}) {
    for (const double wavelength : {1e-9, 1e-4, 1.0}) {
      SceneDesc desc = textured_scene();
      desc.texture->height = height;
      desc.texture->wavelength = wavelength;
      for (const TickRecord& record : slid(desc, 0.03, 0.2, 0)) {
        ASSERT_TRUE(record.device_F_H_D.is_finite());
        ASSERT_LE(record.device_F_H_D.force.norm(), desc.device.max_force * (1 + 1e-12));
      }
    }
  }
}

TEST(TextureInAWorld, ADeviceThatDoesNotPushHasNone) {
  SceneDesc desc = textured_scene();
  desc.device.renders_force = false;
  desc.device.kinematics = Kinematics::none;
  EXPECT_FALSE(slid(desc, 0.05, 0.01, 0).back().texture);
  const std::vector<LeftOut> left_out = left_out_effects(desc, desc);
  EXPECT_TRUE(std::ranges::any_of(left_out, [](const LeftOut& part) { return part.name == "texture"; }));
}

TEST(TextureInAWorld, WhatIsNoRidgeIsRefused) {
  for (const auto& [wavelength, height, direction] :
       {std::tuple(0.0, 1e-5, Vec3(1, 0, 0)), std::tuple(1e-3, -1e-5, Vec3(1, 0, 0)),
        std::tuple(1e-3, std::nan(""), Vec3(1, 0, 0)), std::tuple(1e-3, 1e-5, Vec3(0, 0, 0))}) {
    SceneDesc desc = textured_scene();
    desc.texture = TextureDesc{wavelength, height, direction, 1};
    const Result<World> world = World::build(desc);
    ASSERT_FALSE(world);
    EXPECT_NE(world.error().sentence.find("texture."), std::string::npos) << world.error().sentence;
  }
}

}  // namespace
}  // namespace fulcrum::test
