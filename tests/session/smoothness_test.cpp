// The spectral arc length against a Fourier sum written out term by term, and against what it must not depend
// on.

#include "engine/session/smoothness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fulcrum::session {
namespace {

// Speed of a minimum-jerk reach (Flash and Hogan, 1985) of that length that takes that long, sampled at rate.
std::vector<double> reach(double length, double duration, double rate_Hz) {
  std::vector<double> speed;
  for (double t = 0; t <= duration; t += 1 / rate_Hz) {
    const double s = t / duration;
    speed.push_back(30 * length / duration * s * s * (1 - s) * (1 - s));
  }
  return speed;
}

// The definition, with sums in place of a fast transform.
double by_sums(const std::vector<double>& speed, double rate_Hz) {
  std::size_t padded = 1;
  while (padded < speed.size()) padded *= 2;
  padded *= 16;
  std::vector<double> magnitude;
  std::size_t last = 0;
  for (std::size_t k = 0; static_cast<double>(k) * rate_Hz / static_cast<double>(padded) <= 10; ++k) {
    double re = 0, im = 0;
    for (std::size_t n = 0; n < speed.size(); ++n) {
      const double phase =
          2 * std::numbers::pi * static_cast<double>(k * n % padded) / static_cast<double>(padded);
      re += speed[n] * std::cos(phase);
      im -= speed[n] * std::sin(phase);
    }
    magnitude.push_back(std::sqrt(re * re + im * im));
    if (magnitude.back() / magnitude.front() >= 0.05) last = k;
  }
  double length = 0;
  for (std::size_t k = 1; k <= last; ++k) {
    const double across = 1.0 / static_cast<double>(last);
    const double down = (magnitude[k] - magnitude[k - 1]) / magnitude.front();
    length += std::sqrt(across * across + down * down);
  }
  return -length;
}

TEST(Smoothness, IsTheArcLengthOfTheSpectrum) {
  for (const double duration : {0.6, 1.0, 2.3}) {
    const std::vector<double> speed = reach(0.2, duration, 100);
    const auto length = spectral_arc_length(speed, 0.01);
    ASSERT_TRUE(length);
    EXPECT_NEAR(*length, by_sums(speed, 100), 1e-9);
    EXPECT_NEAR(*length, -1.42, 0.06);
  }
}

TEST(Smoothness, DoesNotDependOnHowFarAMovementGoes) {
  const auto near = spectral_arc_length(reach(0.01, 1, 100), 0.01);
  const auto far = spectral_arc_length(reach(0.5, 1, 100), 0.01);
  ASSERT_TRUE(near && far);
  EXPECT_NEAR(*near, *far, 1e-9);
}

TEST(Smoothness, IsWorseForEachSubmovementAndForTremor) {
  std::vector<double> once = reach(0.2, 1, 100), twice, trembling = once;
  for (int i = 0; i < 2; ++i) twice.insert(twice.end(), once.begin(), once.end());
  for (std::size_t i = 0; i < trembling.size(); ++i)
    trembling[i] += 0.1 * std::abs(std::sin(2 * std::numbers::pi * 4 * 0.01 * static_cast<double>(i)));
  const auto one = spectral_arc_length(once, 0.01);
  const auto two = spectral_arc_length(twice, 0.01);
  const auto shaken = spectral_arc_length(trembling, 0.01);
  ASSERT_TRUE(one && two && shaken);
  EXPECT_LT(*two, *one - 0.5);
  EXPECT_LT(*shaken, *one - 0.05);
}

TEST(Smoothness, HasNoNumberWhereNothingCanBeSaid) {
  EXPECT_FALSE(spectral_arc_length({}, 0.01));
  EXPECT_FALSE(spectral_arc_length(std::vector<double>(19, 1.0), 0.01));
  EXPECT_FALSE(spectral_arc_length(std::vector<double>(200, 0.0), 0.01)) << "nothing moved";
  EXPECT_FALSE(spectral_arc_length(reach(0.2, 10, 15), 1.0 / 15)) << "too sparse for 10 Hz";
  EXPECT_FALSE(spectral_arc_length(reach(0.2, 1, 100), 0));
  std::vector<double> broken = reach(0.2, 1, 100);
  broken[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(spectral_arc_length(broken, 0.01));
}

}  // namespace
}  // namespace fulcrum::session
