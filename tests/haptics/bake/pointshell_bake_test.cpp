#include "haptics/bake/pointshell_bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "haptics/bake/surface_samples.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

double nearest(const Pointshell& shell, const Vec3& p) {
  double least = 1e9;
  for (const Vec3& q : shell.positions) least = std::min(least, (p - q).norm());
  return least;
}

TEST(PointshellBake, CoversTheSurfaceWithinWhatItStates) {
  const Solid solid = shapes::solid_of(shapes::torus(0.03, 0.01, 60, 24));
  const auto shell = bake_pointshell(solid, {2e-3});
  ASSERT_TRUE(shell) << shell.error().sentence;
  EXPECT_LT(shell->covering_radius_m, 2e-3);
  double farthest = 0.0;
  for (const SurfacePoint& sample : sample_surface(solid.mesh, 1e-6, 99).points)
    farthest = std::max(farthest, nearest(*shell, sample.position));
  EXPECT_LE(farthest, shell->covering_radius_m);
  EXPECT_GT(farthest, 0.85 * shell->covering_radius_m);
}

TEST(PointshellBake, WeightsSumToTheSurface) {
  const Solid solid = shapes::solid_of(shapes::torus(0.03, 0.01, 60, 24));
  const auto shell = bake_pointshell(solid, {2e-3});
  ASSERT_TRUE(shell);
  const double area = surface_area(solid.mesh);
  EXPECT_NEAR(std::accumulate(shell->areas_m2.begin(), shell->areas_m2.end(), 0.0), area, 1e-9 * area);
  // As many points as a triangular lattice of that spacing has.
  EXPECT_NEAR(static_cast<double>(shell->size()), 1.1547 * area / 4e-6, 0.15 * area / 4e-6);
  for (const Vec3& n : shell->normals) EXPECT_NEAR(n.norm(), 1.0, 1e-12);
}

TEST(PointshellBake, KeepsCornersAndEdges) {
  const Vec3 size(0.02, 0.03, 0.011);
  const auto shell = bake_pointshell(shapes::solid_of(shapes::box(Vec3::Zero(), size)), {2e-3});
  ASSERT_TRUE(shell);
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) * size.x(), ((i >> 1) & 1) * size.y(), ((i >> 2) & 1) * size.z());
    EXPECT_EQ(nearest(*shell, corner), 0.0);
  }
  for (double s = 0.0; s <= 1.0; s += 0.01) {
    double least = 1e9;  // to a point that lies on the edge itself
    for (const Vec3& q : shell->positions)
      if (q.y() == 0.0 && q.z() == 0.0) least = std::min(least, std::abs(q.x() - s * size.x()));
    EXPECT_LE(least, 1e-3 + 1e-12);
  }
}

TEST(PointshellBake, ARimWithoutCornersIsSampledAllAround) {
  TriangleMesh disc;  // a cylinder: two sharp loops
  constexpr std::uint32_t kSides = 48;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kSides;
    disc.vertices.emplace_back(0.01 * std::cos(a), 0.0, 0.01 * std::sin(a));
    disc.vertices.emplace_back(0.01 * std::cos(a), 0.005, 0.01 * std::sin(a));
    const std::uint32_t j = (i + 1) % kSides;
    disc.triangles.push_back({2 * i, 2 * i + 1, 2 * j + 1});
    disc.triangles.push_back({2 * i, 2 * j + 1, 2 * j});
    disc.triangles.push_back({2 * kSides, 2 * i, 2 * j});
    disc.triangles.push_back({2 * kSides + 1, 2 * j + 1, 2 * i + 1});
  }
  disc.vertices.emplace_back(0.0, 0.0, 0.0);
  disc.vertices.emplace_back(0.0, 0.005, 0.0);
  const auto shell = bake_pointshell(shapes::solid_of(disc), {1e-3});
  ASSERT_TRUE(shell) << shell.error().sentence;
  for (std::uint32_t i = 0; i < 2 * kSides; ++i) EXPECT_LE(nearest(*shell, disc.vertices[i]), 0.51e-3);
}

TEST(PointshellBake, BothSidesOfAThinPlateHavePoints) {
  const auto shell =
      bake_pointshell(shapes::solid_of(shapes::box(Vec3::Zero(), Vec3(0.04, 0.0004, 0.04))), {2e-3});
  ASSERT_TRUE(shell);
  int above = 0, below = 0;
  for (const Vec3& n : shell->normals) {
    above += n.y() > 0.9 ? 1 : 0;
    below += n.y() < -0.9 ? 1 : 0;
  }
  EXPECT_GT(above, 300);
  EXPECT_NEAR(above, below, 40);
}

TEST(PointshellBake, SameSeedSameShell) {
  const Solid solid = shapes::solid_of(shapes::torus(0.03, 0.01, 40, 16));
  const auto first = bake_pointshell(solid, {3e-3}), again = bake_pointshell(solid, {3e-3});
  PointshellDesc other_desc{3e-3};
  other_desc.seed = 2;
  const auto other = bake_pointshell(solid, other_desc);
  ASSERT_TRUE(first && again && other);
  EXPECT_EQ(first->positions, again->positions);
  EXPECT_EQ(first->areas_m2, again->areas_m2);
  EXPECT_NE(first->positions, other->positions);
}

TEST(PointshellBake, NonsenseIsRefused) {
  const Solid solid = shapes::solid_of(shapes::box(Vec3::Zero(), Vec3::Ones()));
  EXPECT_FALSE(bake_pointshell(solid, {0.0}));
  EXPECT_FALSE(bake_pointshell(solid, {std::nan("")}));
  const auto fine = bake_pointshell(solid, {1e-4});
  ASSERT_FALSE(fine);
  EXPECT_NE(fine.error().sentence.find("points: use a spacing of"), std::string::npos)
      << fine.error().sentence;
}

}  // namespace
}  // namespace fulcrum
