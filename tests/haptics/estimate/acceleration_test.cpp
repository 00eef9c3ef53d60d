// References: motions whose acceleration is known, the steady filter's transfer function, and the covariance
// recursion run until it no longer changes.

#include "haptics/estimate/acceleration.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "haptics/math/split_mix.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr AccelerationEstimatorKind kBoth[] = {AccelerationEstimatorKind::kalman,
                                               AccelerationEstimatorKind::adaptive};

AccelerationEstimatorDesc named(AccelerationEstimatorKind kind, double jerk = 5, double noise = 2.9e-6) {
  AccelerationEstimatorDesc desc;
  desc.kind = kind;
  desc.jerk = jerk;
  desc.noise = noise;
  return desc;
}

// From position to acceleration at the angular frequency w, of the steady filter.
std::complex<double> transfer(const SteadyFilter& filter, double w, double tick_s) {
  using Mat4c = Eigen::Matrix4cd;
  const std::complex<double> z = std::polar(1.0, w * tick_s);
  Mat4 correct = Mat4::Identity();
  correct.col(0) -= filter.gain;
  const Mat4c M = z * Mat4c::Identity() - (correct * filter.F).cast<std::complex<double>>();
  const Eigen::Vector4cd x = M.lu().solve(z * filter.gain.cast<std::complex<double>>());
  return x[2] / (tick_s * tick_s);
}

TEST(Acceleration, ConstantAccelerationIsExactToRounding) {
  for (AccelerationEstimatorKind kind : kBoth) {
    for (double tick_s : {1e-2, 1e-3, 1e-4}) {
      AccelerationEstimator estimator(named(kind), tick_s);
      const Vec3 a(1, -2, 0.5), v(0.1, 0.2, -0.3);
      Vec3 seen = Vec3::Zero();
      double t = 0;
      for (int i = 0; t < 1; ++i) {
        t = i * tick_s;
        seen = estimator.update(Vec3(0.5, 0, 0) + v * t + 0.5 * t * t * a);
      }
      // A position of 1 m is rounded by 1e-16 m: over the filter's memory that is 1e-9 m/s^2 at most.
      EXPECT_LT((seen - a).norm(), 1e-7) << tick_s;
      EXPECT_LT((estimator.velocity() - v - a * t).norm(), 1e-9) << tick_s;
    }
  }
}

TEST(Acceleration, ASineComesThroughAsTheTransferFunctionSays) {
  for (double jerk : {1.0, 5.0, 100.0}) {
    for (double f_Hz : {1.0, 5.0, 20.0, 60.0}) {
      AccelerationEstimator estimator(named(AccelerationEstimatorKind::kalman, jerk), kTick);
      const double w = 2 * std::numbers::pi * f_Hz;
      std::complex<double> sum;
      for (int i = 0; i < 4000; ++i) {
        const double a = estimator.update(Vec3(0, 1e-3 * std::sin(w * i * kTick), 0)).y();
        if (i >= 3000) sum += a * std::polar(1.0, -w * i * kTick);
      }
      const std::complex<double> seen = sum * (2.0 / 1000) / 1e-3 * std::complex<double>(0, 1);
      const std::complex<double> expected = transfer(estimator.steady(), w, kTick);
      EXPECT_LT(std::abs(seen - expected), 1e-6 * std::abs(expected)) << jerk << ' ' << f_Hz;
    }
  }
}

// The phase of a slow sine.
TEST(Acceleration, LagIsAsStated) {
  for (AccelerationEstimatorKind kind : kBoth) {
    for (double jerk : {1.0, 5.0, 1000.0}) {
      const AccelerationEstimator estimator(named(kind, jerk), kTick);
      const double w = 0.2;
      const std::complex<double> H = transfer(estimator.steady(), w, kTick) / (-w * w);
      EXPECT_NEAR(-std::arg(H) / w, estimator.lag(), 1e-3 * estimator.lag()) << jerk;
    }
  }
}

TEST(Acceleration, NoiseIsAsStated) {
  for (double noise : {1e-7, 2.9e-6, 1e-4}) {
    AccelerationEstimator estimator(named(AccelerationEstimatorKind::kalman, 5, noise), kTick);
    SplitMix random(1);
    double squares = 0;
    constexpr int kTicks = 200'000;
    for (int i = 0; i < 2000 + kTicks; ++i) {
      const Vec3 a = estimator.update(noise * Vec3(random.normal(), random.normal(), random.normal()));
      if (i >= 2000) squares += a.squaredNorm() / 3;
    }
    EXPECT_NEAR(std::sqrt(squares / kTicks), estimator.noise(), 0.02 * estimator.noise()) << noise;
  }
}

// The gain against the covariance recursion, run on until it stands still.
TEST(Acceleration, TheSteadyGainIsWhereTheRecursionEnds) {
  for (AccelerationEstimatorKind kind : kBoth) {
    for (double jerk : {0.01, 5.0, 1e4, 1e8}) {
      const AccelerationEstimatorDesc desc = named(kind, jerk);
      const KalmanModel model = kalman_model(
          desc.jerk, desc.noise, kind == AccelerationEstimatorKind::adaptive ? desc.jerk_time : 0, kTick);
      Mat4 P = model.Q;
      for (int i = 0; i < 20'000; ++i) {
        const Vec4 gain = P.col(0) / (P(0, 0) + 1);
        P = (model.F * (P - gain * P.row(0)) * model.F.transpose() + model.Q).eval();
        P = (0.5 * (P + P.transpose())).eval();
      }
      const Vec4 gain = P.col(0) / (P(0, 0) + 1), steady = steady_filter(model, kTick).gain;
      EXPECT_LT((gain - steady).norm(), 1e-6 * gain.norm()) << jerk;
    }
  }
}

// Of three states the process noise is known in closed form, and four states with a jerk that is correlated
// for much less than a tick are three.
TEST(Acceleration, TheFourStatesTendToTheThree) {
  const SteadyFilter three = steady_filter(kalman_model(5, 2.9e-6, 0, kTick), kTick);
  const SteadyFilter four = steady_filter(kalman_model(5, 2.9e-6, 1e-3 * kTick, kTick), kTick);
  EXPECT_LT((three.gain.head<3>() - four.gain.head<3>()).norm(), 1e-2 * three.gain.norm());
  EXPECT_NEAR(four.a_rms, three.a_rms, 1e-2 * three.a_rms);
}

TEST(Acceleration, HealthyAtAnyJerkAndRate) {
  for (AccelerationEstimatorKind kind : kBoth) {
    for (double tick_s : {1e-2, 1e-3, 1e-4}) {
      double last_lag = std::numeric_limits<double>::infinity();
      for (double jerk : {1e-12, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e15}) {
        AccelerationEstimator estimator(named(kind, jerk), tick_s);
        EXPECT_TRUE(std::isfinite(estimator.noise()));
        EXPECT_LE(estimator.lag(), last_lag * (1 + 1e-6)) << jerk << ' ' << tick_s;
        last_lag = estimator.lag();
        SplitMix random(3);
        double largest = 0;
        for (int i = 0; i < 20'000; ++i) {
          const double x = std::round(0.05 * (1 - std::cos(3 * i * tick_s)) / 10e-6) * 10e-6;
          largest = std::max(largest, estimator.update(Vec3(x, 0, 1e-5 * random.normal())).norm());
        }
        // What moves it is 0.45 m/s^2 and noise, of which the most nervous filter makes second differences
        // with weights of less than 40 in all.
        EXPECT_LT(largest, 1 + 40 * 6e-5 / (tick_s * tick_s)) << jerk << ' ' << tick_s;
        EXPECT_GT(largest, 0) << jerk << ' ' << tick_s;
      }
    }
  }
}

// An encoder of 30 um in a motion that strikes and stops: at 5.6 ms of lag the estimate scatters by less than
// 0.75 m/s^2 about the lagging acceleration.
TEST(Acceleration, AnEncoderOf30umScattersByLessThanThreeQuarters) {
  AccelerationEstimator clean(named(AccelerationEstimatorKind::kalman, 10, 30e-6 / std::sqrt(12.0)), kTick);
  AccelerationEstimator coarse = clean;
  EXPECT_NEAR(clean.lag(), 5.6e-3, 0.05e-3);
  double squares = 0;
  constexpr int kTicks = 4000;
  for (int i = 0; i < kTicks; ++i) {
    const double x = 0.02 * std::sin(7 * i * kTick) + 0.003 * std::sin(23 * i * kTick);
    const double a = clean.update(Vec3(x, 0, 0)).x();
    squares += std::pow(coarse.update(Vec3(std::round(x / 30e-6) * 30e-6, 0, 0)).x() - a, 2);
  }
  const double rms = std::sqrt(squares / kTicks);
  EXPECT_LT(rms, 0.75);
  EXPECT_GT(rms, 0.5 * clean.noise()) << "an encoder makes noise";
}

// At rest it grows quiet, and a motion makes it quick again: it errs less than the steady filter of its own
// model in both.
TEST(Acceleration, TheAdaptiveFollowsWhatItSees) {
  const AccelerationEstimatorDesc desc = named(AccelerationEstimatorKind::adaptive);
  AccelerationEstimator estimator(desc, kTick);
  const SteadyFilter steady = estimator.steady();
  Vec4 state = Vec4::Zero();
  SplitMix random(5);
  double rest[2] = {}, moving[2] = {};
  for (int i = 0; i < 6000; ++i) {
    const double t = std::max(0.0, i * kTick - 3), w = 2 * std::numbers::pi * 6;
    const double x = 0.01 * (1 - std::cos(w * t)), a = i * kTick > 3 ? 0.01 * w * w * std::cos(w * t) : 0;
    const double y = x + desc.noise * random.normal();
    state = (steady.F * state).eval();
    state += steady.gain * (y / desc.noise - state[0]);
    const double errors[2] = {estimator.update(Vec3(y, 0, 0)).x() - a,
                              state[2] * desc.noise / (kTick * kTick) - a};
    for (int k = 0; k < 2; ++k) {
      if (i > 1000 && i < 3000) rest[k] += errors[k] * errors[k];
      if (i > 3500) moving[k] += errors[k] * errors[k];
    }
  }
  EXPECT_LT(rest[0], 0.6 * rest[1]);
  EXPECT_LT(moving[0], 0.6 * moving[1]);
}

TEST(Acceleration, WhatIsNotANumberStartsItAnew) {
  for (AccelerationEstimatorKind kind : kBoth) {
    AccelerationEstimator estimator(named(kind), kTick), fresh(named(kind), kTick);
    for (int i = 0; i < 50; ++i) estimator.update(Vec3(0.01 * i, 0, 0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(estimator.update(Vec3(nan, 0, 0)), Vec3::Zero());
    EXPECT_EQ(estimator.update(Vec3(0, std::numeric_limits<double>::infinity(), 0)), Vec3::Zero());
    for (int i = 0; i < 50; ++i) {
      const Vec3 p(1e-4 * i * i, 0.1, 0);
      EXPECT_EQ(estimator.update(p), fresh.update(p));
    }
  }
}

}  // namespace
}  // namespace fulcrum::test
