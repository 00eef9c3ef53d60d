// What a device holds of the samples, against the tone that was asked for, at ticks that divide its period
// and at ticks that do not.

#include "haptics/signal/held_sine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "haptics/signal/ramp.h"

namespace fulcrum {
namespace {

constexpr double kTone = 200;  // Hz

// The amplitude at frequency f of the staircase that holds each sample for a tick, exactly integrated.
double held_amplitude(const std::vector<double>& samples, double f, double tick_s) {
  using namespace std::complex_literals;
  const double w = 2 * std::numbers::pi * f;
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) * tick_s;
    sum += samples[i] * (std::exp(-1i * w * t) - std::exp(-1i * w * (t + tick_s))) / (1i * w);
  }
  return 2 * std::abs(sum) / (static_cast<double>(samples.size()) * tick_s);
}

TEST(HeldSine, HoldsTheAmplitudeThatWasAskedForAtAnyTickRate) {
  for (const double rate : {500.0, 777.0, 1000.0, 1300.0, 2500.0, 4000.0, 10000.0, 20000.0}) {
    HeldSine sine(kTone, 1 / rate);
    // Whole periods of both: rates and tone are whole numbers of Hz, so a second holds whole numbers of each.
    std::vector<double> samples(static_cast<std::size_t>(rate));
    for (double& sample : samples) sample = sine.next();
    EXPECT_NEAR(held_amplitude(samples, kTone, 1 / rate), 1.0, 1e-9) << rate;
    for (const double sample : samples) EXPECT_LE(std::abs(sample), sine.largest() * (1 + 1e-12));
  }
}

// ground truth: at 1 kHz a held sine keeps .9355 of its amplitude, and from phase 0 its samples reach .951.
TEST(HeldSine, AtAKilohertzItIsTheSameFiveSamplesForEver) {
  HeldSine sine(kTone, 1e-3);
  EXPECT_NEAR(1 / sine.largest(), 0.9355, 5e-5);
  std::vector<double> first;
  for (int i = 0; i < 5; ++i) first.push_back(sine.next());
  EXPECT_EQ(first[0], 0.0);
  EXPECT_NEAR(first[1] / sine.largest(), 0.951, 1e-4);
  for (std::size_t i = 5; i < 3'600'000; ++i) ASSERT_NEAR(sine.next(), first[i % 5], 1e-9) << i;
}

TEST(HeldSine, StartsAnewAtNothing) {
  HeldSine sine(kTone, 1.0 / 1300);
  for (int i = 0; i < 7; ++i) sine.next();
  sine.restart();
  EXPECT_EQ(sine.next(), 0.0);
}

TEST(Ramp, TakesItsTimeAtAnyTickRateAndStopsAtItsTarget) {
  for (const double tick_s : {1e-3, 0.25e-3, 3e-3}) {
    Ramp ramp(30e-3, tick_s);
    int ticks = 0;
    while (ramp.towards(1.0) < 1.0) ++ticks;
    EXPECT_NEAR((ticks + 1) * tick_s, 30e-3, 1.01 * tick_s);  // rounding may cost a tick
    EXPECT_EQ(ramp.towards(1.0), 1.0);
    EXPECT_EQ(ramp.towards(0.999), 0.999);
  }
  Ramp at_once(1e-6, 1e-3);
  EXPECT_EQ(at_once.towards(1.0), 1.0);
}

}  // namespace
}  // namespace fulcrum
