#include "haptics/bake/field_bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "haptics/bake/triangle_distance.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

// Two bars that cross, turned off the grid's axes, and a torus through them: edges, corners, creases, an
// overlap.
TriangleMesh cluster() {
  TriangleMesh mesh = shapes::box(Vec3(-40, -6, -5) * 1e-3, Vec3(40, 6, 5) * 1e-3);
  shapes::append(mesh, shapes::box(Vec3(-7, -30, -8) * 1e-3, Vec3(7, 30, 8) * 1e-3));
  shapes::append(mesh, shapes::torus(0.03, 0.005, 48, 16));
  return shapes::rotated(mesh, Quat(0.9, 0.2, -0.3, 0.25).normalized());
}

// What the header promises, everywhere: inside, on edges, in and out of band, in and out of the grid.
TEST(FieldBake, NeverOverestimatesByMoreThanItStates) {
  const Solid solid = shapes::solid_of(cluster());
  const auto field = bake_field(solid, {1.5e-3, 6e-3});
  ASSERT_TRUE(field) << field.error().sentence;
  const TriangleDistance exact(solid);
  EXPECT_GT(field->error_bound_m(), 0.0);
  EXPECT_LE(field->error_bound_m(),
            (std::numbers::sqrt3 / 2.0 * field->voxel_m() + 0.5 * field->quantum_m()) * (1.0 + 1e-6));

  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> anywhere(-0.08, 0.08);
  std::normal_distribution<double> nearby(0.0, 1e-3);
  std::uniform_int_distribution<std::size_t> vertex(0, solid.mesh.vertices.size() - 1);
  int beyond_local = 0, in_band = 0;
  for (int i = 0; i < 60000; ++i) {
    const Vec3 offset(nearby(random), nearby(random), nearby(random));
    const Vec3 p = i % 2 == 0 ? Vec3(anywhere(random), anywhere(random), anywhere(random))
                              : Vec3(solid.mesh.vertices[vertex(random)] + offset);
    const double truth = exact.signed_distance(p);
    const FieldSample found = field->sample(p);
    ASSERT_EQ(found.distance, field->distance(p));
    if (found.in_band) {
      ++in_band;
      ASSERT_LE(std::abs(found.distance - truth), field->error_bound_m()) << p.transpose();
      beyond_local += std::abs(found.distance - truth) > field->local_error_m(p) ? 1 : 0;
    } else {
      ASSERT_LE(std::abs(found.distance), std::abs(truth) + field->local_error_m(p) + 1e-9) << p.transpose();
      if (std::abs(found.distance) > 0.0) ASSERT_EQ(found.distance > 0.0, truth > 0.0) << p.transpose();
    }
    if (std::abs(truth) < field->band_m() - field->local_error_m(p)) ASSERT_TRUE(found.in_band);
  }
  EXPECT_GT(in_band, 30000);
  EXPECT_LE(beyond_local, in_band / 1000);
}

TEST(FieldBake, SphereErrorIsOfSecondOrder) {
  const double R = 0.02;
  const Solid solid = shapes::solid_of(shapes::sphere(Vec3(0.001, 0.002, 0.003), R, 150));
  std::vector<double> errors;
  for (const double h : {2e-3, 1e-3}) {
    const auto field = bake_field(solid, {h, 3.0 * h});
    ASSERT_TRUE(field) << field.error().sentence;
    double worst = 0.0;
    for (const Vec3& p : solid.mesh.vertices) worst = std::max(worst, field->distance(p));
    EXPECT_NEAR(worst, h * h / (4.0 * R), 0.15 * h * h / (4.0 * R));
    EXPECT_GE(field->error_bound_m(), worst);
    errors.push_back(worst);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.5);
}

TEST(FieldBake, OverlappingBodiesAreOne) {
  TriangleMesh mesh = shapes::box(Vec3(-20, -10, -10) * 1e-3, Vec3(5, 10, 10) * 1e-3);
  shapes::append(mesh, shapes::box(Vec3(-5, -10, -10) * 1e-3, Vec3(20, 10, 10) * 1e-3));
  const auto field = bake_field(shapes::solid_of(mesh), {1e-3, 4e-3});
  ASSERT_TRUE(field);
  for (double x = -0.019; x < 0.019; x += 1e-3) EXPECT_LT(field->distance(Vec3(x, 0, 0)), 0.0);
  EXPECT_NEAR(field->distance(Vec3(0, 0.012, 0)), 0.002, 1e-6);
}

TEST(FieldBake, GradientPointsOutEvenDeepInside) {
  const auto field =
      bake_field(shapes::solid_of(shapes::box(Vec3::Constant(-0.05), Vec3(0.05, 0.05, 0.05))), {1e-3, 3e-3});
  ASSERT_TRUE(field);
  const FieldSample deep = field->sample(Vec3(0.03, 0.002, 0.001));
  EXPECT_FALSE(deep.in_band);
  EXPECT_LT(deep.distance, 0.0);
  EXPECT_GT(deep.gradient.x(), 0.7);
  EXPECT_NEAR((field->sample(Vec3(0.051, 0.002, 0.001)).gradient - Vec3::UnitX()).norm(), 0.0, 1e-3);
}

TEST(FieldBake, SameBitsForAnyNumberOfThreads) {
  const Solid solid = shapes::solid_of(cluster());
  const auto one = bake_field(solid, {2e-3, 4e-3, FieldFormat::int16, 1});
  ASSERT_TRUE(one);
  for (const unsigned threads : {2u, 5u}) {
    const auto many = bake_field(solid, {2e-3, 4e-3, FieldFormat::int16, threads});
    ASSERT_TRUE(many);
    EXPECT_EQ(one->data().brick_slot, many->data().brick_slot);
    EXPECT_EQ(one->data().centre_m, many->data().centre_m);
    EXPECT_EQ(one->data().values_int16, many->data().values_int16);
    EXPECT_EQ(one->data().slot_error_m, many->data().slot_error_m);
    EXPECT_EQ(one->thinnest_feature_m(), many->thinnest_feature_m());
  }
}

TEST(FieldBake, ProgressRisesToOne) {
  double last = 0.0;
  const auto field = bake_field(shapes::solid_of(cluster()), {2e-3, 4e-3}, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  EXPECT_TRUE(field);
  EXPECT_EQ(last, 1.0);
}

TEST(FieldBake, ThinWallsAreMeasuredAndRefused) {
  TriangleMesh plate = shapes::box(Vec3(0, 0, 0), Vec3(0.05, 0.0015, 0.04));
  const auto refused = bake_field(shapes::solid_of(plate), {1e-3, 4e-3});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("is 1.5 mm thick"), std::string::npos) << refused.error().sentence;
  EXPECT_NE(refused.error().sentence.find("use a voxel of 0.5 mm"), std::string::npos)
      << refused.error().sentence;
  const auto finer = bake_field(shapes::solid_of(plate), {0.5e-3, 2e-3});
  ASSERT_TRUE(finer) << finer.error().sentence;
  EXPECT_NEAR(finer->thinnest_feature_m(), 1.5e-3, 1e-9);

  // The same plate on a block is not thin.
  shapes::append(plate, shapes::box(Vec3(-0.01, -0.03, -0.01), Vec3(0.06, 0.0, 0.05)));
  const auto backed = bake_field(shapes::solid_of(plate), {1e-3, 4e-3});
  EXPECT_TRUE(backed) << backed.error().sentence;
}

TEST(FieldBake, NonsenseIsRefused) {
  const Solid solid = shapes::solid_of(shapes::box(Vec3::Zero(), Vec3::Ones()));
  EXPECT_FALSE(bake_field(solid, {0.0, 1e-2}));
  EXPECT_FALSE(bake_field(solid, {-1e-3, 1e-2}));
  EXPECT_FALSE(bake_field(solid, {std::nan(""), 1e-2}));
  EXPECT_FALSE(bake_field(solid, {1e-2, 1e-2}));
  EXPECT_FALSE(bake_field(solid, {1e-6, 1e-2}));
  const auto large = bake_field(shapes::solid_of(shapes::box(Vec3::Zero(), Vec3::Constant(0.2))),
                                {1e-3, 0.3, FieldFormat::float32});
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().sentence.find("GB: use a voxel of"), std::string::npos) << large.error().sentence;
}

}  // namespace
}  // namespace fulcrum
