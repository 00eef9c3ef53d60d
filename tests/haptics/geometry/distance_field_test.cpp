#include "haptics/geometry/distance_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/haptics/geometry/filled_field.h"

namespace fulcrum {
namespace {

double sphere(const Vec3& p, double R) {
  return p.norm() - R;
}
double torus(const Vec3& p) {
  return std::hypot(std::hypot(p.x(), p.z()) - 1.0, p.y()) - 0.3;
}

// The largest interpolation error at cell centres within one voxel of the surface.
double largest_error(const DistanceField& field, const FieldFunction& function) {
  double worst = 0.0;
  const double h = field.voxel_m();
  const int cells = field.data().bricks[0] * kBrickCells;
  for (int k = 0; k < cells; ++k) {
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        const Vec3 p = field.data().origin + h * Vec3(i + 0.5, j + 0.5, k + 0.5);
        if (std::abs(function(p)) > h) continue;
        worst = std::max(worst, std::abs(field.distance(p) - function(p)));
      }
    }
  }
  return worst;
}

// Ground truths: largest error h^2/(4R), positive, order 2.
TEST(DistanceField, SphereErrorIsThatOfTrilinearSampling) {
  const double R = 1.0;
  const auto function = [R](const Vec3& p) { return sphere(p, R); };
  double previous = 0.0;
  for (const int n : {4, 8}) {
    const double h = 2.4 / (n * kBrickCells);
    const double error = largest_error(filled_field(n, h, function), function);
    EXPECT_NEAR(error, h * h / (4.0 * R), 0.12 * h * h / (4.0 * R));
    if (previous > 0.0) EXPECT_NEAR(previous / error, 4.0, 0.3);
    previous = error;
  }
}

TEST(DistanceField, TorusErrorIsThatOfTrilinearSampling) {
  const DistanceField field = filled_field(4, 0.1, torus);
  double worst = 0.0;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (int i = 0; i < 400000; ++i) {
    const double a = angle(random), b = angle(random), along = 1.0 + 0.3 * std::cos(b);
    worst = std::max(worst,
                     std::abs(field.distance({along * std::cos(a), 0.3 * std::sin(b), along * std::sin(a)})));
  }
  EXPECT_NEAR(worst, 5.18e-3, 0.1e-3);
}

TEST(DistanceField, GradientIsUnitAndPointsAway) {
  const DistanceField field = filled_field(4, 0.1, torus);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
    const FieldSample found = field.sample(p);
    EXPECT_TRUE(found.in_band);
    EXPECT_NEAR(found.gradient.norm(), 1.0, 1e-12);
    EXPECT_EQ(found.distance, field.distance(p));
    if (std::abs(torus(p)) > 0.1 || std::hypot(p.x(), p.z()) < 0.5) continue;
    const double e = 1e-6;
    const Vec3 exact(torus(p + Vec3(e, 0, 0)) - torus(p), torus(p + Vec3(0, e, 0)) - torus(p),
                     torus(p + Vec3(0, 0, e)) - torus(p));
    EXPECT_GT(found.gradient.dot(exact / e), 0.9);
  }
}

TEST(DistanceField, ALinearFunctionIsReproducedExactlyAcrossBricks) {
  const auto plane = [](const Vec3& p) { return 0.25 * p.x() - 0.5 * p.y() + 0.75 * p.z(); };
  const DistanceField field = filled_field(2, 0.125, plane);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
    EXPECT_NEAR(field.distance(p), plane(p), 1e-6);
  }
}

TEST(DistanceField, AFlatFieldStillHasAUnitGradient) {
  const FieldSample found =
      filled_field(2, 0.1, [](const Vec3&) { return -0.5; }).sample(Vec3(0.03, 0.04, 0.05));
  EXPECT_EQ(found.gradient, Vec3(Vec3::UnitY()));
}

TEST(DistanceField, OutsideTheGridItIsTheDistanceToTheBounds) {
  const DistanceField field = filled_field(2, 0.1, [](const Vec3& p) { return sphere(p, 0.5); });
  const FieldSample found = field.sample(Vec3(0.0, 4.8, 3.8));
  EXPECT_FALSE(found.in_band);
  EXPECT_NEAR(found.distance, 5.0, 1e-9);
  EXPECT_NEAR((found.gradient - Vec3(0.0, 0.8, 0.6)).norm(), 0.0, 1e-9);
}

TEST(DistanceField, WhatIsNotANumberIsFarOutside) {
  const DistanceField field = filled_field(1, 0.1, [](const Vec3& p) { return sphere(p, 0.2); });
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1e300, -1e300}) {
    for (const Vec3& p : {Vec3(bad, 0, 0), Vec3(0, bad, 0), Vec3(0, 0, bad), Vec3(bad, bad, bad)}) {
      const FieldSample found = field.sample(p);
      EXPECT_EQ(found.distance, kFarOutside_m);
      EXPECT_FALSE(found.in_band);
      EXPECT_NEAR(found.gradient.norm(), 1.0, 1e-12);
    }
  }
}

TEST(DistanceField, TheGridsOwnFacesBelongToIt) {
  const auto plane = [](const Vec3& p) { return p.x(); };
  const DistanceField field = filled_field(2, 0.1, plane);
  EXPECT_NEAR(field.distance(field.grid_box().max()), field.grid_box().max().x(), 1e-6);
  EXPECT_NEAR(field.distance(field.grid_box().min()), field.grid_box().min().x(), 1e-6);
}

TEST(DistanceField, QuantisingErrsByHalfAQuantumAtMostAndSaysSo) {
  const auto function = [](const Vec3& p) { return torus(p); };
  const DistanceField exact = filled_field(3, 0.1, function);
  FieldData data = exact.data();
  data.band_m = 0.3;
  data.error_bound_m = 0.0;
  quantise(data);
  const DistanceField stored(data);
  const double quantum = stored.quantum_m();
  EXPECT_EQ(stored.format(), FieldFormat::int16);
  EXPECT_NEAR(quantum, (0.3 + 9 * std::sqrt(3.0) * 0.1) / 32767, 1e-3 * quantum);
  EXPECT_GE(stored.error_bound_m(), 0.5 * quantum);
  EXPECT_LE(stored.error_bound_m(), 0.51 * quantum);
  EXPECT_LT(stored.bytes(), 0.6 * static_cast<double>(exact.bytes()));
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  double worst = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
    const double error = std::abs(stored.distance(p) - exact.distance(p));
    worst = std::max(worst, error);
    ASSERT_LE(error, stored.local_error_m(p) * (1 + 1e-6));
  }
  EXPECT_GT(worst, 0.25 * quantum) << "nothing was quantised";
}

}  // namespace
}  // namespace fulcrum
