// What channels get and what vibrators make of it, against the formulas of a resonance and of a lag.

#include "haptics/actuation/vibrotactile_output.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tests/haptics/actuation/simulated_vibrator.h"

namespace fulcrum::test {
namespace {

ChannelDesc coil(double rate_Hz = 48000, double quality = 3) {
  return {.name = "left", .largest = 10, .rate_Hz = rate_Hz, .resonance_Hz = 233, .quality = quality};
}

ChannelDesc rumble() {
  return {.name = "left", .kind = ChannelKind::rumble, .largest = 10, .lag = 0.04};
}

constexpr VibrotactileSignal kSignal{.carrier_Hz = 233, .largest = 10};

// All drives of a channel whose command is told(t) at each tick.
template <class Told>  // VibrotactileCommand (double s)
std::vector<double> played(const ChannelDesc& channel, double tick_s, double duration, Told told) {
  ChannelOutput output(channel, kSignal, tick_s);
  std::vector<double> drives;
  for (int n = 0; n * tick_s < duration; ++n) {
    const VibrotactileCommand command = told(n * tick_s);
    const auto due = output.process(command.level[0], command);
    drives.insert(drives.end(), due.begin(), due.end());
  }
  return drives;
}

TEST(VibrotactileVibrator, AnswersAToneAsItsTransferFunctionSays) {
  for (const double quality : {0.6, 3.0, 15.0}) {
    for (const double f : {60.0, 180.0, 233.0, 300.0, 700.0}) {
      const ChannelDesc channel = coil(48000, quality);
      const std::complex<double> s(0, 2 * std::numbers::pi * f);
      const double w0 = 2 * std::numbers::pi * 233;
      const double H = std::abs(s * s / (s * s + w0 / quality * s + w0 * w0)) / quality;
      EXPECT_NEAR(actuator_response(channel, f), H, 1e-12) << f;
      SimulatedVibrator actuator(channel, 1 / 48000.0);
      double most = 0;
      for (int n = 0; n < 48000; ++n) {
        const double a = actuator.advance(0.5 * std::sin(2 * std::numbers::pi * f * n / 48000));
        if (n > 24000) most = std::max(most, std::abs(a));
      }
      EXPECT_NEAR(most, 0.5 * 10 * H, 0.005 * 0.5 * 10 * H) << quality << ' ' << f;
    }
  }
}

// Switched on, it rings and dies away as a damped oscillator does.
TEST(VibrotactileVibrator, RingsAsADampedOscillator) {
  const double T = 1 / 48000.0, w0 = 2 * std::numbers::pi * 233, d = w0 / (2 * 3.0);
  const double w_d = std::sqrt(w0 * w0 - d * d);
  SimulatedVibrator actuator(coil(), T);
  for (int n = 0; n < 2000; ++n) {
    const double t = n * T;
    const auto v = [&](double at) { return std::exp(-d * at) * std::sin(w_d * at) / w_d; };  // of a unit step
    const double truth = 10.0 / 3 * (v(t + T) - v(t)) / T;
    ASSERT_NEAR(actuator.advance(1), truth, 1e-9) << n;
  }
}

TEST(VibrotactileVibrator, RumbleFollowsWithItsLag) {
  for (const double tick_s : {1e-2, 1e-3, 1e-4}) {
    SimulatedVibrator actuator(rumble(), tick_s);
    double t = 0;
    for (int n = 1; n * tick_s < 0.2; ++n) {
      t = n * tick_s;
      ASSERT_NEAR(actuator.advance(0.7), 7 * (1 - std::exp(-t / 0.04)), 1e-9) << t;
    }
    const double top = 7 * (1 - std::exp(-t / 0.04));
    for (int n = 1; n * tick_s < 0.2; ++n)
      ASSERT_NEAR(actuator.advance(0), top * std::exp(-n * tick_s / 0.04), 1e-9);
  }
}

// A vibrator that is driven at its carrier shakes as strongly as the level says, at its resonance or beside.
TEST(VibrotactileOutput, TheFingerGetsTheLevelThatWasAskedFor) {
  for (const double resonance_Hz : {150.0, 233.0, 320.0}) {
    ChannelDesc channel = coil();
    channel.resonance_Hz = resonance_Hz;
    const double level = 0.9 * actuator_reach(channel, 233);
    ChannelOutput output(channel, kSignal, 1e-4);
    SimulatedVibrator vibrator(channel, 1 / channel.rate_Hz);
    double most = 0;
    for (int n = 0; n < 10000; ++n) {
      for (const double drive : output.process(level, {.glide = 0.01})) {
        const double a = vibrator.advance(drive);
        if (n > 5000) most = std::max(most, std::abs(a));
      }
    }
    EXPECT_NEAR(most, level, 0.02 * level) << resonance_Hz;
  }
}

// Of every rate and tick: no envelope step above 1 % of I_max, as many samples as there have to be, none
// beyond the drive, whatever is asked for.
TEST(VibrotactileOutput, TheEnvelopeNeverSteps) {
  for (const double rate_Hz : {1000.0, 8000.0, 44100.0, 48000.0}) {
    for (const double tick_s : {1e-2, 1e-3, 1e-4, 1 / rate_Hz}) {  // with the last, sample by sample
      ChannelOutput output(coil(rate_Hz), kSignal, tick_s);
      double before = 0;
      std::size_t samples = 0;
      for (int n = 0; n * tick_s < 1; ++n) {
        const double level = n / 37 % 2 == 0 ? 9.0 : (n / 11 % 3) * 4.0;
        VibrotactileCommand command;
        command.glide = n % 5 == 0 ? 0.01 : tick_s;
        const auto drives = output.process(level, command);
        samples += drives.size();
        EXPECT_LE(std::abs(output.envelope() - before),
                  0.01 * 10 * static_cast<double>(drives.size()) + 1e-12);
        before = output.envelope();
        for (const double drive : drives) EXPECT_LE(std::abs(drive), 1);
      }
      EXPECT_EQ(samples, static_cast<std::size_t>(rate_Hz)) << rate_Hz << ' ' << tick_s;
    }
  }
}

// The samples are carrier x envelope; from 0 to 8 in 10 ms, and held there.
TEST(VibrotactileOutput, SamplesAreCarrierTimesEnvelope) {
  const double w = 2 * std::numbers::pi * 233 / 48000, larger = (w / 2) / std::sin(w / 2);
  const std::vector<double> drives = played(coil(), 1e-3, 0.05, [](double) {
    return VibrotactileCommand{.level = {8, 0, 0, 0}, .glide = 0.01};
  });
  ASSERT_EQ(drives.size(), 2400u);
  for (std::size_t n = 0; n < drives.size(); ++n) {
    const double k = static_cast<double>(n), envelope = 8 * std::min(1.0, (k + 1) / 480);
    EXPECT_NEAR(drives[n], envelope / 10 * larger * std::sin(w * k), 1e-9) << n;
  }
}

// Silent within 2 ms of a stop, in a straight line, from wherever it was.
TEST(VibrotactileOutput, AStopSilencesWithinTwoMilliseconds) {
  for (const double rate_Hz : {8000.0, 48000.0}) {
    for (const double tick_s : {1e-3, 5e-4}) {
      ChannelOutput output(coil(rate_Hz), kSignal, tick_s);
      for (int n = 0; n * tick_s < 0.1; ++n) output.process(9, {.glide = 0.01});
      EXPECT_DOUBLE_EQ(output.envelope(), 9);
      const int ticks = static_cast<int>(std::lround(2e-3 / tick_s));
      for (int n = 1; n <= ticks; ++n) {
        const double level = 9.0 * (ticks - n) / ticks;
        output.process(level, {.glide = tick_s, .stopping = true});
        EXPECT_NEAR(output.envelope(), level, 1e-9);
      }
      for (const double drive : output.process(0, {.glide = tick_s, .stopping = true})) EXPECT_EQ(drive, 0);
    }
  }
}

// However soon after its onset the stop comes: the level that it falls from is not yet heard, and never will
// be.
TEST(VibrotactileOutput, AStopOnTheWayUpOnlyFalls) {
  for (const double tick_s : {1e-3, 5e-5}) {
    for (const double after_s : {1e-3, 5e-3}) {
      ChannelOutput output(coil(), kSignal, tick_s);
      for (int n = 0; n * tick_s < after_s - 1e-9; ++n) output.process(9, {.glide = 0.01});
      double before = output.envelope();
      EXPECT_NEAR(before, 9 * after_s / 0.01, 0.05 * 9) << tick_s;
      const double loudest = before / 10 * HeldSine(233, 1 / 48000.0).largest();
      const int ticks = static_cast<int>(std::lround(2e-3 / tick_s));
      for (int n = 1; n <= ticks; ++n) {
        const auto drives = output.process(9.0 * (ticks - n) / ticks, {.glide = tick_s, .stopping = true});
        EXPECT_LE(output.envelope(), before) << tick_s << ' ' << n;
        before = output.envelope();
        for (const double drive : drives) EXPECT_LE(std::abs(drive), loudest + 1e-12) << tick_s << ' ' << n;
      }
      EXPECT_EQ(output.envelope(), 0) << tick_s;
    }
  }
}

TEST(VibrotactileOutput, RumbleAndToneAreToldTheirDrive) {
  for (const ChannelKind kind : {ChannelKind::rumble, ChannelKind::tone}) {
    ChannelDesc channel = rumble();
    channel.kind = kind;
    const std::vector<double> drives = played(channel, 1e-3, 0.1, [](double t) {
      return VibrotactileCommand{.level = {t < 0.05 ? 4.0 : 0.0, 0, 0, 0}, .glide = 0.01};
    });
    ASSERT_EQ(drives.size(), 100u);
    EXPECT_DOUBLE_EQ(drives[10], 0.4);
    EXPECT_EQ(drives[60], 0);
  }
}

// An effect that has gone wrong asks for what is not a number: that is no drive, and above all not the whole.
TEST(VibrotactileOutput, WhatIsNotANumberIsNone) {
  for (const ChannelKind kind : {ChannelKind::rumble, ChannelKind::tone, ChannelKind::pcm}) {
    ChannelDesc channel = kind == ChannelKind::pcm ? coil() : rumble();
    channel.kind = kind;
    ChannelOutput output(channel, kSignal, 1e-3);
    for (int n = 0; n < 50; ++n) output.process(4, {.glide = 0.01});
    EXPECT_EQ(output.envelope(), 4);
    for (int n = 0; n < 50; ++n) {
      for (const double drive : output.process(std::nan(""), {.glide = 0.01})) {
        ASSERT_LE(std::abs(drive), 0.45) << n;
        if (n > 10) ASSERT_EQ(drive, 0) << n;
      }
    }
    EXPECT_EQ(output.envelope(), 0);
  }
}

}  // namespace
}  // namespace fulcrum::test
