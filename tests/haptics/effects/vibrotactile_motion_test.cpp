// The law of vibrotactile motion against its formulas, on exact motions.

#include "haptics/effects/vibrotactile_motion/vibrotactile_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace fulcrum::test {
namespace {

constexpr double kWindow = 10e-3;  // m

VibrotactileDesc two_channels() {
  const ChannelDesc coil{.name = "left", .largest = 12.84, .resonance_Hz = 233, .quality = 3};
  VibrotactileDesc desc{{coil, coil}};
  desc.channels[1].name = "right";
  return desc;
}

struct Moment {
  double time, x;  // s; m
  VibrotactileRecord cues;
  bool updated;  // a new level was told
};

// Along x(t), from its start to `duration`, with a velocity that is exact.
std::vector<Moment> swept(
    const VibrotactileMotionDesc& desc, double tick_s, double duration,
    const std::function<double(double)>& x,
    const std::function<bool(double)>& touching = [](double) { return true; }) {
  const VibrotactileDesc channels = two_channels();
  VibrotactileMotion motion(desc, &channels, 1, tick_s);
  std::vector<Moment> moments;
  for (int n = 0; n * tick_s < duration; ++n) {
    const double t = n * tick_s;
    VibrotactileMotion::Tick tick{
        .p_WH = Vec3(x(t), 0, 0),
        .v_WH = Vec3(std::round((x(t) - x(t - tick_s)) / tick_s * 1e9) * 1e-9, 0, 0)};
    tick.touching = touching(t);
    motion.process(tick);
    const VibrotactileCommand& command = motion.render(1, false);
    const bool updated = moments.empty() || command.level != moments.back().cues.command.level;
    moments.push_back({t, x(t), motion.record(), updated});
  }
  return moments;
}

// (left, right), of the paper's Eqs. 4 and 5 and the page's mirrored ones.
std::array<double, 2> expected(const VibrotactileMotionDesc& desc, double x, int direction) {
  const double s = direction * x;
  if (direction == 0 || s < 0 || s > kWindow) return {0, 0};
  const auto share = [&](double y) {
    return desc.law.envelope == MotionEnvelope::linear
               ? y / kWindow
               : std::log(1 + y / desc.law.reference) / std::log(1 + kWindow / desc.law.reference);
  };
  const double trailing = desc.strength * share(s), leading = desc.strength * share(kWindow - s);
  return direction > 0 ? std::array{trailing, leading} : std::array{leading, trailing};
}

TEST(MotionLaw, HalfWayTheLogarithmGoesByItsReference) {
  MotionLaw law;
  const std::vector<std::pair<double, double>> known{{1e-3, 0.747}, {1e-2, 0.585}, {1.0, 0.501}};
  for (const auto& [reference, level] : known) {
    law.reference = reference;
    const MotionLevels levels = motion_levels(law, kWindow / 2, 0);
    EXPECT_NEAR(levels.leading, level, 5e-4) << reference;
    EXPECT_DOUBLE_EQ(levels.leading, levels.trailing) << reference;
  }
}

TEST(MotionLaw, AtItsEndsOneVibratorIsWholeAndTheOtherSilent) {
  for (const MotionEnvelope envelope : {MotionEnvelope::linear, MotionEnvelope::logarithmic}) {
    const MotionLaw law{.envelope = envelope};
    EXPECT_DOUBLE_EQ(motion_levels(law, 0, 0).leading, 1);
    EXPECT_DOUBLE_EQ(motion_levels(law, 0, 0).trailing, 0);
    EXPECT_DOUBLE_EQ(motion_levels(law, kWindow, 0).leading, 0);
    EXPECT_DOUBLE_EQ(motion_levels(law, kWindow, 0).trailing, 1);
    EXPECT_EQ(motion_levels(law, -1e-9, 0).leading, 0);
    EXPECT_EQ(motion_levels(law, kWindow + 1e-9, 0).trailing, 0);
  }
}

// The second onset comes 0.32 T_s + 0.0473 s after the first while that is less than T_s: T_s > 69.56 ms.
TEST(MotionLaw, AsynchronousOnsetsAreThePapersWhereTheyCanBe) {
  const MotionLaw law{.onset = MotionOnset::asynchronous};
  for (const double T_s : {0.0697, 0.1, 0.5, 2.0}) {
    const double speed = kWindow / T_s;
    EXPECT_NEAR(trailing_onset(law, speed) / speed, 0.32 * T_s + 0.0473, 1e-12) << T_s;
    EXPECT_NEAR(trailing_onset(law, -speed), trailing_onset(law, speed), 0) << T_s;
  }
  for (const double T_s : {0.0695, 0.05, 0.005}) EXPECT_EQ(trailing_onset(law, kWindow / T_s), 0) << T_s;
  const double onset = trailing_onset(law, 0.05);
  EXPECT_EQ(motion_levels(law, onset, onset).trailing, 0);
  EXPECT_GT(motion_levels(law, onset + 1e-5, onset).trailing, 0);
  EXPECT_DOUBLE_EQ(motion_levels(law, kWindow, onset).trailing, 1);
  EXPECT_DOUBLE_EQ(motion_levels(law, 4e-3, onset).leading, motion_levels(law, 4e-3, 0).leading);
}

// At whatever speed and tick rate: each level that is told is the law's at the place where it is told, there
// are as many of them as there have to be, and outside there are none.
TEST(VibrotactileMotion, LevelsAreTheLawsAtEachUpdate) {
  for (const MotionEnvelope envelope : {MotionEnvelope::linear, MotionEnvelope::logarithmic}) {
    for (const double speed : {0.005, 0.05, 0.2, 0.35, 2.0}) {
      for (const int direction : {1, -1}) {
        for (const double rate_Hz : {100.0, 350.0, 1000.0, 10000.0, 20000.0}) {
          VibrotactileMotionDesc desc;
          desc.law.envelope = envelope;
          const double tick_s = 1 / rate_Hz;
          const auto moments =
              swept(desc, tick_s, 0.04 / speed, [&](double t) { return direction * (speed * t - 0.02); });
          int inside = 0, updates = 0;
          double last = -1;  // s, of the last update
          for (const Moment& m : moments) {
            const int heading =
                m.time > 3 * tick_s + SweepDirection::kMin / speed ? direction : m.cues.direction;
            EXPECT_EQ(m.cues.direction, heading);
            const std::array<double, 2> law = expected(desc, m.x, direction);
            const bool in = law[0] + law[1] > 0;
            inside += in;
            if (m.updated && in) {
              ++updates;
              EXPECT_NEAR(m.cues.command.level[0], law[0], 0.01 * desc.strength) << speed << ' ' << m.x;
              EXPECT_NEAR(m.cues.command.level[1], law[1], 0.01 * desc.strength) << speed << ' ' << m.x;
              if (last >= 0) EXPECT_LT(m.time - last, std::max(0.01, tick_s) + tick_s);
              last = m.time;
            }
            if (!in) {
              EXPECT_EQ(m.cues.command.level[0], 0) << m.x;
              EXPECT_EQ(m.cues.command.level[1], 0) << m.x;
            }
          }
          const double pass = kWindow / speed;
          const double every = speed > 0.2 ? tick_s : std::max(tick_s, 0.01);
          EXPECT_NEAR(updates, pass / every, 1.5 + 0.2 * pass / every) << speed << " at " << rate_Hz;
          EXPECT_NEAR(inside, pass * rate_Hz, 1.01) << speed << " at " << rate_Hz;
          if (pass * rate_Hz > 1) {
            EXPECT_GT(inside, 0) << speed << " at " << rate_Hz;
            EXPECT_GT(updates, 0) << speed << " at " << rate_Hz;
          }
        }
      }
    }
  }
}

// In time: the trailing vibrator begins 0.32 T + 0.0473 s after the leading one, to an update; on a pass that
// is too fast for it, with it.
TEST(VibrotactileMotion, TheSecondOnsetComesLaterByTheAsynchrony) {
  VibrotactileMotionDesc desc;
  desc.law.onset = MotionOnset::asynchronous;
  for (const double speed : {0.01, 0.05, 0.1, 0.14, 0.16, 0.2}) {
    const double T_s = kWindow / speed, soa = 0.32 * T_s + 0.0473;
    double leading = 0, trailing = 0;
    for (const Moment& m : swept(desc, 1e-4, 0.04 / speed, [&](double t) { return speed * t - 0.02; })) {
      if (leading == 0 && m.cues.command.level[1] > 0) leading = m.time;
      if (trailing == 0 && m.cues.command.level[0] > 0) trailing = m.time;
    }
    ASSERT_GT(leading, 0) << speed;
    EXPECT_GE(trailing - leading, soa < T_s ? soa - 1e-4 : 0.0) << speed;
    EXPECT_LE(trailing - leading, (soa < T_s ? soa : 0.0) + 0.0102) << speed;
  }
}

TEST(VibrotactileMotion, TurnsRoundWithTheHandAndEntersAgain) {
  // To 8 mm, back to -8 mm, and again: the window is that of the way the finger goes.
  const double speed = 0.1;
  const auto x = [&](double t) {
    const double way = std::fmod(speed * t, 0.064);
    return way < 0.008   ? way - 0.0
           : way < 0.024 ? 0.016 - way
           : way < 0.04  ? way - 0.032
           : way < 0.056 ? 0.048 - way
                         : way - 0.064;
  };
  VibrotactileMotionDesc desc;
  int passes = 0;
  bool was_in = false;
  for (const Moment& m : swept(desc, 1e-3, 1.28, x)) {
    const double v = x(m.time + 1e-6) - x(m.time - 1e-6);
    const int direction = v > 0 ? 1 : -1;
    const bool turning = m.cues.direction != direction;  // for as long as it takes to go back by kMin
    if (turning) {
      EXPECT_LT(std::abs(std::abs(m.x) - 0.008), 0.4e-3 + (m.time < 0.003 ? 1 : 0)) << m.time;
      continue;
    }
    const std::array<double, 2> law = expected(desc, m.x, direction);
    const bool in = direction * m.x >= 0;
    if (in && !was_in) ++passes;
    was_in = in;
    if (!in) {
      EXPECT_EQ(m.cues.command.level[0] + m.cues.command.level[1], 0) << m.time << ' ' << m.x;
    } else if (m.updated) {
      EXPECT_NEAR(m.cues.command.level[0], law[0], 0.01 * desc.strength) << m.time;
      EXPECT_NEAR(m.cues.command.level[1], law[1], 0.01 * desc.strength) << m.time;
    }
  }
  EXPECT_EQ(passes, 8);
}

// What is a turn is told by the hand's way, however large the scene makes it.
TEST(VibrotactileMotion, ATurnIsThatOfTheHandle) {
  const VibrotactileDesc channels = two_channels();
  for (const double scale : {1.0, 3.0}) {
    for (const double back_handle : {0.24e-3, 0.26e-3}) {
      VibrotactileMotion motion({}, &channels, scale, 1e-3);
      int direction = 0;
      for (int n = 0; n < 100; ++n) {
        const double x = n < 90 ? 5e-5 * n : 5e-5 * 89 - scale * back_handle * (n - 89) / 10;
        motion.process({.p_WH = Vec3(x, 0, 0), .v_WH = Vec3::Zero(), .touching = true});
        direction = motion.record().direction;
      }
      EXPECT_EQ(direction, back_handle < SweepDirection::kMin ? 1 : -1) << scale;
    }
  }
}

TEST(VibrotactileMotion, LiftedOffOrAtRestItIsSilent) {
  const VibrotactileMotionDesc desc;
  const auto sweep = [](double t) { return 0.05 * t - 1e-3; };
  for (const Moment& m :
       swept(desc, 1e-3, 0.3, sweep, [](double t) { return t < 0.08 || (t > 0.11 && t < 0.15); })) {
    const bool touching = m.time < 0.08 || (m.time > 0.11 && m.time < 0.15);
    const double sum = m.cues.command.level[0] + m.cues.command.level[1];
    if (!touching) EXPECT_EQ(sum, 0) << m.time;
    if (touching && m.x > 0) EXPECT_GT(sum, 0.9 * desc.strength) << m.time;
  }
  const auto halted = [](double t) { return std::min(0.05 * t, 5e-3) - 1e-3; };
  for (const Moment& m : swept(desc, 1e-3, 0.4, halted)) {
    const double sum = m.cues.command.level[0] + m.cues.command.level[1];
    if (m.time > 0.1 + SweepDirection::kRest + 2e-3) EXPECT_EQ(sum, 0) << m.time;
    if (m.time > 0.021 && m.time < 0.1 + SweepDirection::kRest - 4e-3) EXPECT_GT(sum, 0) << m.time;
  }
}

TEST(VibrotactileMotion, WhatAChannelCannotDoIsMissing) {
  VibrotactileMotionDesc desc;
  desc.strength = 20;
  double shortfall = 0, most = 0;
  for (const Moment& m : swept(desc, 1e-3, 0.3, [](double t) { return 0.05 * t - 1e-3; })) {
    shortfall = std::max(shortfall, m.cues.shortfall);
    most = std::max(most, m.cues.command.level[1]);
  }
  const double reach = 12.84 / (std::numbers::pi * 233 / 48000 / std::sin(std::numbers::pi * 233 / 48000));
  EXPECT_NEAR(most, reach, 1e-9);
  EXPECT_NEAR(shortfall + most, 20, 0.01 * 20);
}

// Windows and speeds beyond all sense: levels stay within their bounds.
TEST(VibrotactileMotion, ExtremesStayWithinBounds) {
  for (const double window : {1e-4, 1e-2, 1.0}) {
    for (const double rate_Hz : {100.0, 10000.0}) {
      VibrotactileMotionDesc desc;
      desc.law.window = window;
      desc.lateral_force = 2;
      for (const Moment& m : swept(desc, 1 / rate_Hz, 2, [](double t) { return 0.5 * std::sin(20 * t); })) {
        for (const double level : m.cues.command.level) {
          EXPECT_GE(level, 0);
          EXPECT_LE(level, desc.strength);
        }
        EXPECT_LE(std::abs(m.cues.force), 2);
      }
    }
  }
}

// F_lat = -sat(v/v0) F_mag, in the window, whole one update after the edge, and never along the motion.
TEST(VibrotactileMotion, TheForceIsAgainstTheSweepInItsWindow) {
  VibrotactileMotionDesc desc;
  desc.lateral_force = 2;
  for (const double speed : {0.02, 0.05, 0.2, -0.05, -0.2}) {
    const double v = std::abs(speed);
    for (const Moment& m :
         swept(desc, 1e-3, 0.04 / v, [&](double t) { return speed * t - std::copysign(0.02, speed); })) {
      const double s = m.x * (speed > 0 ? 1 : -1), ramp = 0.0101 * v + 1e-9;
      if (m.time > 0.01) EXPECT_LE(m.cues.force * speed, 0);
      if (s > ramp && s < kWindow)
        EXPECT_NEAR(m.cues.force, -std::clamp(speed / 0.1, -1.0, 1.0) * 2, 1e-9) << speed << ' ' << s;
      if (s < -1e-9 || s > kWindow + ramp) EXPECT_EQ(m.cues.force, 0) << speed << ' ' << s;
    }
  }
}

// In place of force: windows follow one another while the handle goes against it, as strong as it is.
TEST(VibrotactileMotion, AsAFallbackWindowsFollowOneAnother) {
  VibrotactileMotionDesc desc;
  desc.use = VibrotactileUse::fallback;
  desc.law.envelope = MotionEnvelope::linear;
  desc.full_force = 2;
  const VibrotactileDesc channels = two_channels();
  for (const double felt : {-1.0, -4.0, 1.0}) {
    VibrotactileMotion motion(desc, &channels, 1, 1e-3);
    int windows = 0;
    double last = 1;
    for (int n = 0; n < 1000; ++n) {
      motion.process(
          {.p_WH = Vec3::Zero(), .v_WH = Vec3::Zero(), .moved = 5e-5, .speed = 0.05, .felt = felt});
      const VibrotactileCommand& command = motion.render(1, false);
      const double share = felt > 0 ? 0.0 : std::min(1.0, -felt / 2);
      if (n < 5) continue;
      EXPECT_NEAR(command.level[0] + command.level[1], share * desc.strength, 1e-9) << n;
      if (felt > 0) continue;
      const double x = motion.record().x;
      EXPECT_GE(x, 0);
      EXPECT_LT(x, kWindow);
      EXPECT_NEAR(command.level[0], share * desc.strength * x / kWindow, 0.06 * desc.strength) << n;
      windows += x < last;
      last = x;
    }
    EXPECT_EQ(windows, felt > 0 ? 0 : 5) << felt;  // 50 mm
  }
}

}  // namespace
}  // namespace fulcrum::test
