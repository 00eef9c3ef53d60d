// The samples of blows, against their formula in doubles, and against what a listener's instruments would
// find.

#include "engine/audio/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace fulcrum::audio {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

SceneSound steel(DistanceModel distance = DistanceModel::sinusoid) {
  SceneSound scene;
  scene.distance = distance;
  scene.reach = 0.3;
  return scene;
}

double rms(std::span<const float> samples) {
  double sum = 0;
  for (const float y : samples) sum += static_cast<double>(y) * static_cast<double>(y);
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

// |sum y e^(-i w t)| of a stretch.
double part_at(std::span<const float> samples, double frequency_Hz) {
  std::complex<double> sum, turned = 1;
  const std::complex<double> turn = std::polar(1.0, -kTwoPi * frequency_Hz / kRate_Hz);
  for (const float y : samples) {
    sum += static_cast<double>(y) * turned;
    turned *= turn;
  }
  return std::abs(sum);
}

// Hz, where a stretch has most, to 0.1 Hz, from `low` to `high`.
double peak_frequency(std::span<const float> samples, double low, double high) {
  double best = low, most = 0;
  for (double f = low; f <= high; f += 0.1)
    if (const double part = part_at(samples, f); part > most) most = part, best = f;
  return best;
}

TEST(StruckSamples, AreTheFormula) {
  const SceneSound scene = steel(DistanceModel::beam);
  const Blow blow{.speed = 0.2, .radius = 0.21};
  const std::vector<float> samples = struck_samples(scene, blow);
  ASSERT_GT(samples.size(), 48000u);
  // Steel: A 0.8 kg/s, d 5 1/s, f 40 Hz. The clamped beam's shapes at 0.7 of its length, from tables of its
  // own: Rao (2007), phi_n / 2 by the closed form, in long double.
  const long double beta[] = {1.8751040687119611L, 4.6940911329741746L, 7.8547574382376126L};
  long double frequency[3], amplitude[3], sum = 0;
  for (int n = 0; n < 3; ++n) {
    const long double s = (std::cosh(beta[n]) + std::cos(beta[n])) / (std::sinh(beta[n]) + std::sin(beta[n]));
    const long double b = beta[n] * 0.7L;
    amplitude[n] = (std::cosh(b) - std::cos(b) - s * (std::sinh(b) - std::sin(b))) / 2;
    frequency[n] = 16 * 40 * (beta[n] / beta[0]) * (beta[n] / beta[0]);
    sum += std::abs(amplitude[n]);
  }
  const long double x = 0.8L * 0.2L / 0.4L, level = 0.3L * x / (1 + x);
  for (std::size_t i = 0; i < samples.size() - 240; ++i) {
    const long double t = static_cast<long double>(i + 1) / 48000;
    long double y = 0;
    for (int n = 0; n < 3; ++n)
      y += amplitude[n] * std::exp(-5 * t) * std::sin(2 * std::numbers::pi_v<long double> * frequency[n] * t);
    ASSERT_NEAR(static_cast<double>(samples[i]), static_cast<double>(level * y / std::max(1.0L, sum)), 1e-7)
        << i;
  }
}

TEST(StruckSamples, HaveTheFrequencyAndTheDecayOfTheMaterial) {
  SceneSound scene = steel();
  scene.materials = {{"bell", 0.8, 7, 50}};
  // Beside the hand: the material's own frequency, four octaves up.
  const std::vector<float> beside = struck_samples(scene, {.speed = 0.3, .radius = 0});
  EXPECT_NEAR(peak_frequency(std::span(beside).first(24000), 700, 900), 800, 0.3);
  // Half way: (12 + 38 / 2) Hz, four octaves up.
  const std::vector<float> half = struck_samples(scene, {.speed = 0.3, .radius = 0.15});
  EXPECT_NEAR(peak_frequency(std::span(half).first(24000), 400, 600), 16 * 31, 0.3);
  // From 0.1 s to 0.3 s it falls by e^(-7 0.2).
  const double early = rms(std::span(beside).subspan(4800, 2400)),
               later = rms(std::span(beside).subspan(14400, 2400));
  EXPECT_NEAR(std::log(early / later) / 0.2, 7, 0.05);
}

TEST(StruckSamples, AreLouderTheHarderTheBlowAndNeverBeyondTheirPeak) {
  double before = 0;
  for (double speed = 0.01; speed < 1000; speed *= 1.3) {
    for (const DistanceModel distance : {DistanceModel::sinusoid, DistanceModel::beam}) {
      const std::vector<float> samples = struck_samples(steel(distance), {.speed = speed, .radius = 0.3});
      for (const float y : samples) ASSERT_LE(std::abs(y), kPeak);
    }
    const double loud = rms(struck_samples(steel(), {.speed = speed, .radius = 0.1}));
    EXPECT_GT(loud, before) << speed;
    before = loud;
  }
}

TEST(StruckSamples, BeginAndEndWithoutAClick) {
  SceneSound scene = steel();
  scene.materials = {{"stubborn", 0.8, 0.5, 40}};  // rings for far longer than kLongest
  const std::vector<float> samples = struck_samples(scene, {.speed = 5, .radius = 0});
  ASSERT_EQ(samples.size(), 96000u);
  const double steepest = kTwoPi * 640 / kRate_Hz * kPeak * 1.01;  // of the tone itself
  EXPECT_LT(std::abs(samples.front()), steepest);
  EXPECT_EQ(samples.back(), 0);
  for (std::size_t i = 1; i < samples.size(); ++i)
    ASSERT_LT(std::abs(samples[i] - samples[i - 1]), steepest + kPeak / 240) << i;
}

TEST(StruckSamples, OfWhatIsNoBlowThereAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double speed : {0.0, -1.0, nan, inf, -inf})
    EXPECT_TRUE(struck_samples(steel(), {.speed = speed, .radius = 0.1}).empty()) << speed;
  EXPECT_TRUE(struck_samples(steel(), {.speed = 1, .radius = nan}).empty());
  SceneSound high = steel();
  high.materials = {{"whistle", 1, 5, 1400}};
  EXPECT_TRUE(struck_samples(high, {.speed = 1, .radius = 0}).empty());  // 22.4 kHz
  EXPECT_FALSE(struck_samples(steel(), {.speed = 1, .radius = 0.1, .object = 99}).empty());
}

TEST(StruckSamples, AreOfTheObjectThatWasStruck) {
  SceneSound scene = steel();
  scene.materials = {{"steel", 0.8, 5, 40}, {"rubber", 0.4, 25, 18}};
  const auto longer = struck_samples(scene, {.speed = 0.2, .radius = 0, .object = 0});
  const auto shorter = struck_samples(scene, {.speed = 0.2, .radius = 0, .object = 1});
  EXPECT_GT(longer.size(), 4 * shorter.size());
  EXPECT_NEAR(peak_frequency(shorter, 200, 400), 16 * 18, 3);
}

TEST(SlideSamples, GoRoundWithoutASeam) {
  const std::vector<float> samples = slide_samples(steel());
  double steepest = 0, loudest = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    steepest = std::max(steepest, std::abs(static_cast<double>(samples[i] - samples[i - 1])));
    loudest = std::max(loudest, std::abs(static_cast<double>(samples[i])));
  }
  EXPECT_LE(std::abs(samples.front() - samples.back()), steepest);
  EXPECT_NEAR(loudest, 0.12, 1e-6);
  // Most of it lies about the material's frequency.
  EXPECT_GT(part_at(samples, 640), 5 * part_at(samples, 6400));
}

TEST(SlideLevel, GrowsWithTheRootOfThePowerOfFriction) {
  EXPECT_EQ(slide_level({.speed = 0, .force = 5}), 0);
  EXPECT_DOUBLE_EQ(slide_level({.speed = 0.01, .force = 1}) * 2, slide_level({.speed = 0.02, .force = 2}));
  EXPECT_EQ(slide_level({.speed = 10, .force = 10}), 1);
  EXPECT_EQ(slide_level({.speed = std::numeric_limits<double>::quiet_NaN(), .force = 1}), 0);
}

TEST(ChimeSamples, AreDifferentFromEachOtherAndSoft) {
  std::vector<double> highest;
  for (int i = 0; i < kChimes; ++i) {
    const std::vector<float> samples = chime_samples(static_cast<Chime>(i));
    for (const float y : samples) ASSERT_LE(std::abs(y), kPeak);
    EXPECT_EQ(samples.back(), 0);
    EXPECT_GT(rms(samples), 0.005);
    const auto from = samples.size() / 2;
    highest.push_back(peak_frequency(std::span(samples).subspan(from, 4800), 150, 1400));
  }
  EXPECT_NEAR(highest[0], 880, 5);
  EXPECT_NEAR(highest[1], 1318.5, 5);
  EXPECT_LT(highest[2], 220);
}

}  // namespace
}  // namespace fulcrum::audio
