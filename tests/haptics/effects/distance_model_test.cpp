// The beam: a steel rod of 8 x 300 mm rings at 62.768, 393.361 and 1101.42 Hz; its modes are clamped at the
// hand, where neither place nor slope change, free at the end, and at right angles to each other.

#include "haptics/effects/impact_vibration/distance_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum {
namespace {

TEST(DistanceModel, ABeamRingsAsTheRodDoes) {
  // f_1 = beta^2 sqrt(E I / rho A) / (2 pi L^2), I / A = (d / 4)^2.
  const double beta = 1.8751040687, L = 0.3;
  const double f1 = beta * beta * 0.002 * std::sqrt(200e9 / 7850) / (2 * std::numbers::pi * L * L);
  const VibrationModes modes = vibration_modes(DistanceModel::beam, f1, 0.1, L);
  ASSERT_EQ(modes.count, 3u);
  EXPECT_NEAR(modes.modes[0].frequency_Hz, 62.768, 1e-3);
  EXPECT_NEAR(modes.modes[1].frequency_Hz, 393.361, 1e-3);
  EXPECT_NEAR(modes.modes[2].frequency_Hz, 1101.42, 1e-2);
}

TEST(DistanceModel, BeamModesAreThoseOfAClampedFreeBeam) {
  constexpr int n = 4000;
  std::vector<std::vector<double>> a(3);
  for (int i = 0; i <= n; ++i) {
    const VibrationModes modes = vibration_modes(DistanceModel::beam, 40, static_cast<double>(i) / n, 1.0);
    for (std::size_t mode = 0; mode < 3; ++mode) a[mode].push_back(modes.modes[mode].amplitude);
  }
  for (std::size_t mode = 0; mode < 3; ++mode) {
    EXPECT_NEAR(std::abs(a[mode].back()), 1.0, 1e-9) << "at the free end";
    const std::vector<double>& y = a[mode];
    EXPECT_NEAR((y[n] - 2 * y[n - 1] + y[n - 2]) * n * n, 0, 0.1) << "no moment at the free end";
  }
  // The first keeps a tenth beside the hand: its nodes are asked of the others.
  EXPECT_EQ(a[0].front(), 0.1);
  for (std::size_t mode = 1; mode < 3; ++mode) {
    EXPECT_EQ(a[mode].front(), 0.0);
    EXPECT_NEAR((a[mode][1] - a[mode][0]) * n, 0, 0.05);
  }
  double product = 0, square = 0;
  for (int i = 0; i <= n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double weight = i == 0 || i == n ? 0.5 : 1;
    product += weight * a[1][at] * a[2][at] / n;
    square += weight * a[1][at] * a[1][at] / n;
  }
  EXPECT_NEAR(product, 0, 1e-6);
  EXPECT_NEAR(square, 0.25, 1e-6) << "the mean of phi^2 is 1";
}

TEST(DistanceModel, ASinusoidFallsFromTheMaterialToTwelve) {
  double before = 40.0 + 1e-9;
  for (int i = 0; i <= 100; ++i) {
    const VibrationModes modes = vibration_modes(DistanceModel::sinusoid, 40, 0.003 * i, 0.3);
    ASSERT_EQ(modes.count, 1u);
    EXPECT_EQ(modes.modes[0].amplitude, 1.0);
    EXPECT_NEAR(modes.modes[0].frequency_Hz, 40 - 28 * i / 100.0, 1e-9);
    EXPECT_LT(modes.modes[0].frequency_Hz, before);
    before = modes.modes[0].frequency_Hz;
  }
  EXPECT_EQ(vibration_modes(DistanceModel::sinusoid, 40, 7, 0.3).modes[0].frequency_Hz, 12.0);
  EXPECT_EQ(vibration_modes(DistanceModel::sinusoid, 40, 0, 0).modes[0].frequency_Hz, 12.0);
}

}  // namespace
}  // namespace fulcrum
