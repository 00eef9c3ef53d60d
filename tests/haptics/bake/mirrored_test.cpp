// Mirror images of bakes against the definition, written out: the image says at M p what the original says at
// p, its triangles face outwards, and its neighbours share the edges that they should.

#include "haptics/bake/mirrored.h"

#include <gtest/gtest.h>

#include <random>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/triangle_distance.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

const Mat3 M = Vec3(-1, 1, 1).asDiagonal();

// Without a symmetry, away from the origin, and of two components that overlap.
Solid lopsided() {
  TriangleMesh mesh = shapes::box(Vec3(0.01, 0.0, -0.005), Vec3(0.03, 0.006, 0.004));
  shapes::append(mesh, shapes::sphere(Vec3(0.031, 0.007, 0.002), 0.005, 12));
  return shapes::solid_of(mesh);
}

void expect_image(FieldFormat format) {
  const auto field = bake_field(lopsided(), {.voxel_m = 5e-4, .format = format});
  ASSERT_TRUE(field) << field.error().sentence;
  const DistanceField image = mirrored(*field);
  EXPECT_EQ(image.bytes(), field->bytes());
  EXPECT_LT((image.bounds().min() - Vec3(-field->bounds().max().x(), 0.0, -0.005)).norm(), 1e-12);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> x(-0.005, 0.05), y(-0.01, 0.02), z(-0.02, 0.02);
  int in_band = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(x(random), y(random), z(random));
    const FieldSample there = image.sample(M * p), here = field->sample(p);
    EXPECT_NEAR(there.distance, here.distance, 1e-12);
    EXPECT_EQ(there.in_band, here.in_band);
    EXPECT_EQ(image.local_error_m(M * p), field->local_error_m(p));
    if (here.in_band) EXPECT_LT((there.gradient - M * here.gradient).norm(), 1e-9);
    in_band += here.in_band ? 1 : 0;
  }
  EXPECT_GT(in_band, 200);
  EXPECT_EQ(mirrored(image).data().values_float, field->data().values_float);
  EXPECT_EQ(mirrored(image).data().values_int16, field->data().values_int16);
}

TEST(MirroredBake, AFieldSaysTheSameOnTheOtherSide) {
  expect_image(FieldFormat::float32);
}

TEST(MirroredBake, SoDoesOneOfWholeNumbers) {
  expect_image(FieldFormat::int16);
}

TEST(MirroredBake, ASolidStaysWoundOutwardsAndKeepsItsNeighbours) {
  const Solid solid = lopsided(), image = mirrored(solid);
  for (std::size_t t = 0; t < image.mesh.triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t from = image.mesh.triangles[t][e], to = image.mesh.triangles[t][(e + 1) % 3];
      const Triangle& across = image.mesh.triangles[image.neighbours[t][e]];
      int shared = 0;
      for (std::size_t k = 0; k < 3; ++k)  // it runs along the edge the other way
        shared += across[k] == to && across[(k + 1) % 3] == from ? 1 : 0;
      EXPECT_EQ(shared, 1) << t << ", " << e;
    }
  }
  const TriangleDistance to_solid(solid), to_image(image);
  for (const Vec3& p : {Vec3(0.02, 0.003, 0.0), Vec3(0.034, 0.009, 0.002), Vec3(0.0, 0.0, 0.0)})
    EXPECT_NEAR(to_image.signed_distance(M * p), to_solid.signed_distance(p), 1e-15);
  const Solid again = mirrored(image);
  EXPECT_EQ(again.mesh.vertices, solid.mesh.vertices);
  EXPECT_EQ(again.mesh.triangles, solid.mesh.triangles);
  EXPECT_EQ(again.neighbours, solid.neighbours);
}

TEST(MirroredBake, MassPropertiesAreThoseOfTheImage) {
  const MassProperties of = mirrored(mass_properties(lopsided()));
  const MassProperties truth = mass_properties(mirrored(lopsided()));
  EXPECT_NEAR(of.volume_m3, truth.volume_m3, 1e-15 * truth.volume_m3);
  EXPECT_LT((of.centre - truth.centre).norm(), 1e-15);
  EXPECT_LT((of.inertia - truth.inertia).norm(), 1e-12 * truth.inertia.norm());
  EXPECT_GT(std::abs(truth.inertia(0, 1)), 1e-3 * truth.inertia.norm());
}

TEST(MirroredBake, AShellLiesOnTheImageAndFacesOutOfIt) {
  const auto shell = bake_pointshell(lopsided(), {.spacing_m = 1e-3});
  ASSERT_TRUE(shell);
  const Pointshell image = mirrored(*shell);
  ASSERT_EQ(image.size(), shell->size());
  EXPECT_EQ(image.max_radius_m, shell->max_radius_m);
  for (std::size_t i = 0; i < image.size(); ++i) {
    EXPECT_EQ(image.positions[i], M * shell->positions[i]);
    EXPECT_EQ(image.normals[i], M * shell->normals[i]);
  }
}

}  // namespace
}  // namespace fulcrum
