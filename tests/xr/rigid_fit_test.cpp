// The fit of a device's base to a headset's space against transforms that are known, and against what theory
// says of its residual and of its error.

#include "engine/headset/rigid_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "haptics/math/rotation.h"

namespace fulcrum::headset {
namespace {

using Pairs = std::vector<PointPair>;

class Chance {
public:
  explicit Chance(unsigned seed) : generator_(seed) {}
  Vec3 normal(double sigma) {
    std::normal_distribution<double> along(0, sigma);
    const double x = along(generator_), y = along(generator_), z = along(generator_);
    return {x, y, z};
  }
  // far: m, how far the base stands away.
  Pose pose(double far) {
    std::normal_distribution<double> unit;
    const double w = unit(generator_), x = unit(generator_), y = unit(generator_), z = unit(generator_);
    return {Quat(w, x, y, z).normalized(), normal(far)};
  }

private:
  std::mt19937_64 generator_;
};

// So many places on a circle of a desktop device's reach, one of two of them higher: m in D.
std::vector<Vec3> places(int n) {
  constexpr double kPi = 3.141592653589793;
  std::vector<Vec3> p_D;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    p_D.emplace_back(0.07 * std::cos(angle), i % 2 == 0 ? 0.03 : -0.03, 0.07 * std::sin(angle));
  }
  return p_D;
}

Pairs touched(const Pose& X_LD, const std::vector<Vec3>& p_D, double sigma, Chance& chance) {
  Pairs pairs;
  for (const Vec3& p : p_D) pairs.push_back({p, X_LD * p + chance.normal(sigma)});
  return pairs;
}

double turned(const Pose& a, const Pose& b) {
  return angle_of(a.q * b.q.conjugate());
}

// What is to be expected of the residual and of the error elsewhere: J. M. Fitzpatrick, J. B. West, C. R.
// Maurer, "Predicting error in rigid-body point-based registration", IEEE Transactions on Medical Imaging
// 17(5), 1998.
//
// m, the error to be expected (RMS) at a place, where every pair is off by `sigma` (m) along each axis:
//     error^2 = 3 sigma^2 / n (1 + (d_1^2 / f_1^2 + d_2^2 / f_2^2 + d_3^2 / f_3^2) / 3)
// d_k: of the place from the k-th principal axis of the points; f_k: RMS of the points from it.
double expected_error(const Pairs& pairs, const Vec3& p_D, double sigma) {
  const auto n = static_cast<double>(pairs.size());
  Vec3 mean = Vec3::Zero();
  for (const PointPair& pair : pairs) mean += pair.p_D / n;
  Mat3 spread = Mat3::Zero();
  for (const PointPair& pair : pairs) spread += (pair.p_D - mean) * (pair.p_D - mean).transpose() / n;
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(spread);
  const Vec3 away = principal.eigenvectors().transpose() * (p_D - mean);
  double lever = 0;
  for (int k = 0; k < 3; ++k) {
    const double f2 = principal.eigenvalues().sum() - principal.eigenvalues()[k];
    lever += (away.squaredNorm() - away[k] * away[k]) / f2;
  }
  return sigma * std::sqrt(3 * (1 + lever / 3) / n);
}

std::string refusal(const Pairs& pairs) {
  const auto fit = fit_rigid(pairs);
  return fit ? std::string() : fit.error().sentence;
}

// A controller whose place does not follow the handle tells no turn.
TEST(RigidFit, PointsOfTheControllerInOnePlaceOrALineAreRefused) {
  Pairs pairs;
  for (const Vec3& p : places(4)) pairs.push_back({p, {0.1, 1, 0.2}});
  EXPECT_EQ(refusal(pairs),
            "The controller was at one place, or in a line, while the handle was not: hold its tip at the "
            "handle's point each time.");
  for (PointPair& pair : pairs) pair.p_L.x() += pair.p_D.x();
  EXPECT_EQ(refusal(pairs).substr(0, 14), "The controller");
}

TEST(RigidFit, FindsAnyTransformAgain) {
  Chance chance(1);
  for (const double far : {0.0, 1.0, 1000.0})
    for (int n = 3; n <= 12; ++n)
      for (int i = 0; i < 50; ++i) {
        const Pose X_LD = chance.pose(far);
        const auto fit = fit_rigid(touched(X_LD, places(n), 0, chance));
        ASSERT_TRUE(fit) << fit.error().sentence;
        // What a number of `far` m can tell at all.
        const double told = 1e-15 * (1 + far) * 100;
        EXPECT_LT((fit->X_LD * Vec3(0.1, 0, 0) - X_LD * Vec3(0.1, 0, 0)).norm(), told);
        EXPECT_LT(turned(fit->X_LD, X_LD), told / 0.07);
        EXPECT_LT(fit->rms, told);
        ASSERT_EQ(fit->residuals.size(), static_cast<std::size_t>(n));
      }
}

// Of half a turn, and of none: where a rotation is easily taken for a mirror image.
TEST(RigidFit, FindsHalfTurns) {
  Chance chance(2);
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 2, 3).normalized().eval()})
    for (const double angle : {0.0, 3.141592653589793}) {
      const Pose X_LD{turn_by(angle, axis), Vec3(0, 1, -0.5)};
      const auto fit = fit_rigid(touched(X_LD, places(4), 0, chance));
      ASSERT_TRUE(fit);
      EXPECT_LT(turned(fit->X_LD, X_LD), 1e-7);
      EXPECT_LT(fit->rms, 1e-14);
    }
}

// The sum of squared residuals is that of 3 n - 6 numbers.
TEST(RigidFit, ResidualIsThatOfTheory) {
  Chance chance(3);
  constexpr int kTrials = 4000;
  for (const int n : {3, 4, 6, 12}) {
    double squares = 0;
    for (int i = 0; i < kTrials; ++i) {
      const auto fit = fit_rigid(touched(chance.pose(1), places(n), 1e-3, chance));
      ASSERT_TRUE(fit) << fit.error().sentence;
      squares += fit->rms * fit->rms;
    }
    const double degrees = 3 * n - 6;
    const double five_sigma = 5 * std::sqrt(2 / (degrees * kTrials));  // relative, of a mean of chi squares
    EXPECT_NEAR(squares / kTrials / (3e-6 * (1 - 2.0 / n)), 1, five_sigma) << n;
  }
}

// How far from the points what is seen stands beside what is felt. The table is that of docs/headset.md.
TEST(RigidFit, ErrorGrowsWithDistanceAsTheorySays) {
  constexpr int kTrials = 4000;
  std::printf("error in mm, of 1 mm along each axis, found / by theory\npoints");
  const double away[] = {0, 0.05, 0.1, 0.2, 0.4};  // m
  for (const double d : away) std::printf("  at %3.0f mm   ", 1e3 * d);
  for (const int n : {3, 4, 6, 12}) {
    std::printf("\n%6d", n);
    for (const double d : away) {
      const Vec3 p_D = d * Vec3(1, 2, 2) / 3;
      Chance chance(4);
      double squares = 0;
      Pairs pairs;
      for (int i = 0; i < kTrials; ++i) {
        const Pose X_LD = chance.pose(0.5);
        pairs = touched(X_LD, places(n), 1e-3, chance);
        const auto fit = fit_rigid(pairs);
        ASSERT_TRUE(fit) << fit.error().sentence;
        squares += (fit->X_LD * p_D - X_LD * p_D).squaredNorm();
      }
      const double found = std::sqrt(squares / kTrials), theory = expected_error(pairs, p_D, 1e-3);
      std::printf("  %5.2f /%5.2f", 1e3 * found, 1e3 * theory);
      // The theory is of the first order; the mean of so many squares is known to about 2 % besides.
      EXPECT_NEAR(found / theory, 1, 0.05) << n << " points, " << d << " m";
    }
  }
  std::printf("\n");
}

// A mirror image is never taken for a turn: its residual tells it.
TEST(RigidFit, MirrorImageShowsInTheResidual) {
  Chance chance(5);
  Pairs pairs = touched(chance.pose(1), places(4), 0, chance);
  for (PointPair& pair : pairs) pair.p_D.x() *= -1;
  pairs[0].p_D.y() += 0.02;  // and is not its own mirror image
  const auto fit = fit_rigid(pairs);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->X_LD.q.toRotationMatrix().determinant(), 1, 1e-12);
  EXPECT_GT(fit->rms, 0.01);
}

TEST(RigidFit, WhatSaysTooLittleIsRefused) {
  Chance chance(6);
  const Pose X_LD = chance.pose(1);
  const auto of = [&](const std::vector<Vec3>& p_D) { return refusal(touched(X_LD, p_D, 0, chance)); };
  EXPECT_EQ(of({{0, 0, 0}, {0.1, 0, 0}}),
            "Three points are needed at least, and there are 2: touch more of them.");
  EXPECT_EQ(of({{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0.005}}),
            "The points lie nearly in a line, 1.2 mm beside it: touch one well to the side of the others.");
  EXPECT_EQ(of({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.01, 0}, {0, 0, 0.1}}),
            "Points 2 and 3 are 10 mm apart: touch places that are 30 mm apart at least, and better as far "
            "as the handle reaches.");
  EXPECT_NE(of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).find("are 0 mm apart"), std::string::npos);
  for (const double none :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const bool device : {false, true}) {
      Pairs pairs = touched(X_LD, places(4), 0, chance);
      (device ? pairs[2].p_D : pairs[2].p_L).y() = none;
      EXPECT_EQ(refusal(pairs),
                "A point has no place: touch it again, where the headset sees the controller.");
    }
}

// Just beyond what is refused it is found well.
TEST(RigidFit, NarrowPointsThatAreTakenAreFoundWell) {
  Chance chance(7);
  const Pose X_LD = chance.pose(1);
  const auto fit = fit_rigid(touched(X_LD, {{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.022, 0}}, 0, chance));
  ASSERT_TRUE(fit) << fit.error().sentence;
  EXPECT_LT(turned(fit->X_LD, X_LD), 1e-12);
}

}  // namespace
}  // namespace fulcrum::headset
