// Against the closed form, and against its integrals: of y, w / (d^2 + w^2); of y^2, w^2 / (4 d (d^2 + w^2));
// the peak where tan(w t) = w / d. At 12 Hz and 5 1/s: 0.013204842, 0.049781082, 0.903057 at 19.955095 ms.

#include "haptics/signal/decaying_sine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

TEST(DecayingSine, IsTheClosedFormAtEveryTick) {
  for (const double tick_s : {1e-3, 1e-4}) {
    for (const double frequency_Hz : {12.0, 40.0, 251.0}) {
      for (const double decay : {0.5, 5.0, 80.0}) {
        DecayingSine sine(frequency_Hz, decay, tick_s);
        for (int n = 1; n <= 5000; ++n) {
          const double t = n * tick_s;
          const double exact = std::exp(-decay * t) * std::sin(2 * std::numbers::pi * frequency_Hz * t);
          ASSERT_NEAR(sine.next(), exact, 1e-10) << frequency_Hz << " Hz, " << decay << " 1/s, sample " << n;
        }
      }
    }
  }
}

TEST(DecayingSine, HasItsIntegralEnergyAndPeak) {
  constexpr double tick_s = 1e-5;
  DecayingSine sine(12, 5, tick_s);
  double integral = 0, energy = 0, peak = 0, peak_at = 0;
  for (int n = 1; n <= 600000; ++n) {
    const double y = sine.next();
    integral += y * tick_s;
    energy += y * y * tick_s;
    if (y > peak) {
      peak = y;
      peak_at = n * tick_s;
    }
  }
  EXPECT_NEAR(integral, 0.013204842, 1e-8);
  EXPECT_NEAR(energy, 0.049781082, 1e-8);
  EXPECT_NEAR(peak, 0.903057, 1e-6);
  EXPECT_NEAR(peak_at, 0.019955095, tick_s);
}

TEST(DecayingSine, WithoutFiguresIsSilent) {
  DecayingSine sine;
  for (int n = 0; n < 10; ++n) EXPECT_EQ(sine.next(), 0.0);
}

}  // namespace
}  // namespace fulcrum
