#include "haptics/estimate/velocity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/math/rotation.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

VelocityEstimatorDesc named(VelocityEstimatorKind kind) {
  VelocityEstimatorDesc desc;
  desc.kind = kind;
  return desc;
}

constexpr VelocityEstimatorKind kAll[] = {VelocityEstimatorKind::difference, VelocityEstimatorKind::low_pass,
                                          VelocityEstimatorKind::adaptive_window};

TEST(Velocity, ConstantVelocityIsExactInTheEnd) {
  for (VelocityEstimatorKind kind : kAll) {
    VelocityEstimator estimator(named(kind), kTick);
    Twist V;
    for (int i = 0; i < 400; ++i)
      V = estimator.update({quaternion_exp(Vec3(0, 2.0 * i * kTick, 0)), Vec3(0.3 * i * kTick, 0, 0)});
    EXPECT_NEAR(V.v.x(), 0.3, 1e-9);
    EXPECT_NEAR(V.w.y(), 2.0, 1e-9);
  }
}

// Against a slow sine: the phase that an estimator lags by is its stated delay.
TEST(Velocity, DelayIsAsStated) {
  for (VelocityEstimatorKind kind : {VelocityEstimatorKind::difference, VelocityEstimatorKind::low_pass}) {
    VelocityEstimator estimator(named(kind), kTick);
    const double w = 2 * std::numbers::pi * 1.0;
    double in_phase = 0, quadrature = 0;
    for (int i = 0; i < 4000; ++i) {
      const double t = i * kTick,
                   v = estimator.update({Quat::Identity(), Vec3(std::sin(w * t) / w, 0, 0)}).v.x();
      if (i < 2000) continue;
      in_phase += v * std::cos(w * t);
      quadrature += v * std::sin(w * t);
    }
    EXPECT_NEAR(std::atan2(quadrature, in_phase) / w, estimator.delay(), 0.01 * estimator.delay());
  }
}

// A slow motion seen in encoder steps: the adaptive window is far quieter than the difference.
TEST(Velocity, AdaptiveWindowIsQuietAtRest) {
  const auto rms = [](VelocityEstimatorKind kind) {
    VelocityEstimator estimator(named(kind), kTick);
    double sum = 0;
    for (int i = 0; i < 2000; ++i) {
      const double x = std::round(0.005 * i * kTick / 28e-6) * 28e-6;
      sum += std::pow(estimator.update({Quat::Identity(), Vec3(x, 0, 0)}).v.x() - 0.005, 2);
    }
    return std::sqrt(sum / 2000);
  };
  EXPECT_LT(rms(VelocityEstimatorKind::adaptive_window), 0.3 * rms(VelocityEstimatorKind::difference));
}

}  // namespace
}  // namespace fulcrum::test
