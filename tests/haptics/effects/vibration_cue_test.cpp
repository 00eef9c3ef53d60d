#include "haptics/effects/torque_substitution/vibration_cue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr VibrationDesc kVibration{.amplitude = 0.4, .frequency_Hz = 200, .reference = 0.03, .largest = 0.3};

TEST(VibrationCue, IsLogarithmicInTorque) {
  const VibrationCue cue(kVibration, 1e-3);
  EXPECT_EQ(cue.strength(0), 0.0);
  EXPECT_NEAR(cue.strength(0.03), std::log(2.0) / std::log(11.0), 1e-12);
  EXPECT_NEAR(cue.strength(0.12), std::log(5.0) / std::log(11.0), 1e-12);
  EXPECT_EQ(cue.strength(0.3), 1.0);
  EXPECT_EQ(cue.strength(3.0), 1.0);
}

// Between two ticks the tone itself moves by at most A 2 pi f T. Swelling and fading must not add to it.
TEST(VibrationCue, NeitherStartsNorStopsWithAClick) {
  for (const double tick_s : {2e-3, 1e-3, 0.25e-3, 0.1e-3}) {
    VibrationCue cue(kVibration, tick_s);
    const double x = std::numbers::pi * kVibration.frequency_Hz * tick_s;
    const double steepest =
        kVibration.amplitude * (x / std::sin(x)) * 2 * std::sin(x);  // of the held samples
    Vec3 last = Vec3::Zero();
    const auto ticks = static_cast<int>(0.3 / tick_s);
    double largest = 0;
    for (int i = 0; i < ticks; ++i) {
      const bool on = i > ticks / 5 && i < ticks * 3 / 5;
      const Vec3 now = cue.process(on ? 1.0 : 0.0, Vec3(0, 3, 0));
      EXPECT_LE((now - last).norm(), steepest * (1 + 1e-9)) << tick_s << ' ' << i;
      largest = std::max(largest, now.norm());
      last = now;
    }
    EXPECT_GT(largest, 0.9 * kVibration.amplitude);
    EXPECT_EQ(last, Vec3::Zero());
    // The first samples: no more than the swell allows.
    VibrationCue fresh(kVibration, tick_s);
    for (int i = 1; i * tick_s < VibrationCue::kSwell; ++i)
      EXPECT_LE(fresh.process(1.0, Vec3(0, 3, 0)).norm(),
                kVibration.amplitude * (x / std::sin(x)) * i * tick_s / VibrationCue::kSwell * (1 + 1e-9));
  }
}

TEST(VibrationCue, IsAtRightAnglesToTheForceThatIsFelt) {
  VibrationCue cue(kVibration, 1e-3);
  const Vec3 f = Vec3(1, 2, -0.5).normalized();
  EXPECT_EQ(cue.process(0.0, 4 * f), Vec3::Zero());
  for (int i = 0; i < 500; ++i) {
    const Vec3 F = cue.process(1.0, 4 * f);
    EXPECT_NEAR(F.dot(f), 0.0, 1e-12) << i;
  }
}

// A force that swings round by a right angle, onto the tone's own direction, within a tick: the tone follows
// without a step and is across the force again within five time constants.
TEST(VibrationCue, FollowsAForceThatTurnsWithoutAStep) {
  VibrationCue cue(kVibration, 1e-3);
  Vec3 last = Vec3::Zero();
  const double steepest = kVibration.amplitude / 0.9355 * 2 * std::sin(std::numbers::pi * 0.2);
  double along = 0, largest = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 f = i < 500 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitX());
    const Vec3 F = cue.process(1.0, 4 * f);
    EXPECT_LE((F - last).norm(), 1.05 * steepest) << i;
    last = F;
    if (i >= 750) {
      along = std::max(along, std::abs(F.dot(f)));
      largest = std::max(largest, F.norm());
    }
  }
  EXPECT_LT(along, 0.01 * kVibration.amplitude);
  EXPECT_GT(largest, 0.9 * kVibration.amplitude);
}

}  // namespace
}  // namespace fulcrum
