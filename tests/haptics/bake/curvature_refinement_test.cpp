// Shells that follow what bends, judged by pressing them against flat walls; edges of a scene.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "haptics/bake/pointshell_bake.h"
#include "tests/haptics/bake/shapes.h"
#include "tests/haptics/scenes.h"

namespace fulcrum {
namespace {

double support(const std::vector<Vec3>& points, const Vec3& direction) {
  double farthest = -1e9;
  for (const Vec3& p : points) farthest = std::max(farthest, direction.dot(p));
  return farthest;
}

// m: how deep a convex solid goes into walls of any direction before a point of its shell touches.
double deepest_in_a_wall(const Solid& solid, const Pointshell& shell) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  double deepest = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
    deepest =
        std::max(deepest, support(solid.mesh.vertices, direction) - support(shell.positions, direction));
  }
  return deepest;
}

TEST(Bulges, AWallStopsABallWithinTheDeviation) {
  constexpr std::uint32_t kFacets = 64;  // from pole to pole
  const double radius = 6e-3;
  const Solid ball = test::expect(build_solid(shapes::sphere(Vec3::Zero(), radius, kFacets)));
  const auto even = bake_pointshell(ball, {.spacing_m = 4e-3});
  ASSERT_TRUE(even);
  EXPECT_GT(deepest_in_a_wall(ball, *even), 0.3e-3);
  for (const double deviation : {0.2e-3, 0.1e-3, 0.05e-3}) {
    const auto shell = bake_pointshell(ball, {.spacing_m = 4e-3, .deviation = deviation});
    ASSERT_TRUE(shell);
    // Walls between the normals of two neighbouring vertices tilt by half a facet at most.
    const double tilt = std::numbers::pi / (2 * kFacets);
    EXPECT_LT(deepest_in_a_wall(ball, *shell), deviation + tilt * std::sqrt(2 * radius * deviation));
    // Each point serves a cap of the sphere as high as the deviation, area 2 pi r deviation; caps that cover
    // a sphere overlap by half of their area or so.
    const double caps = 2 * radius / deviation;
    EXPECT_GT(static_cast<double>(shell->size()), caps);
    EXPECT_LT(static_cast<double>(shell->size()), 2.5 * caps);
  }
}

TEST(Bulges, WhatIsFlatGetsNoMorePoints) {
  const Solid box = test::expect(build_solid(shapes::box(Vec3::Zero(), Vec3(0.02, 0.03, 0.01))));
  const auto even = bake_pointshell(box, {.spacing_m = 2e-3});
  const auto shell = bake_pointshell(box, {.spacing_m = 2e-3, .deviation = 1e-5});
  ASSERT_TRUE(even && shell);
  EXPECT_EQ(even->size(), shell->size());
}

TEST(Bulges, ADeviationThatIsNoLengthIsRefused) {
  const Solid box = test::expect(build_solid(shapes::box(Vec3::Zero(), Vec3(0.02, 0.03, 0.01))));
  for (const double deviation : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    const auto shell = bake_pointshell(box, {.spacing_m = 2e-3, .deviation = deviation});
    ASSERT_FALSE(shell);
    EXPECT_NE(shell.error().sentence.find("deviation"), std::string::npos);
  }
}

// An L in section: five convex edges along z, and one in its corner, which nothing can be pricked with.
TEST(SceneEdges, AreThoseThatStickOut) {
  TriangleMesh mesh;
  for (const double z : {0.0, 0.02})
    for (const auto& [x, y] :
         {std::pair{0.0, 0.0}, {0.03, 0.0}, {0.03, 0.01}, {0.01, 0.01}, {0.01, 0.03}, {0.0, 0.03}})
      mesh.vertices.emplace_back(x, y, z);
  for (const std::uint32_t i : {1u, 3u}) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({0, i + 2, i + 1});
    mesh.triangles.push_back({6, 6 + i, 7 + i});
    mesh.triangles.push_back({6, 7 + i, 8 + i});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, 6 + j});
    mesh.triangles.push_back({i, 6 + j, 6 + i});
  }
  const Solid block = test::expect(build_solid(mesh));
  const auto edges = bake_edges(block, {.spacing_m = 1e-3});
  ASSERT_TRUE(edges) << edges.error().sentence;
  const auto on_line = [&](double x, double y) {
    return std::count_if(edges->positions.begin(), edges->positions.end(), [&](const Vec3& p) {
      return std::abs(p.x() - x) < 1e-9 && std::abs(p.y() - y) < 1e-9;
    });
  };
  for (const auto& [x, y] : {std::pair{0.03, 0.0}, {0.03, 0.01}, {0.01, 0.03}, {0.0, 0.03}, {0.0, 0.0}})
    EXPECT_GE(on_line(x, y), 21) << x << ' ' << y;
  EXPECT_LE(on_line(0.01, 0.01), 2) << "only where it ends on a face";
  for (const double area : edges->areas_m2) EXPECT_EQ(area, 0.0);
}

TEST(SceneEdges, ARoundSceneHasNone) {
  const Solid ball = test::expect(build_solid(shapes::sphere(Vec3::Zero(), 0.02, 24)));
  const auto edges = bake_edges(ball, {.spacing_m = 1e-3});
  ASSERT_FALSE(edges);
  EXPECT_NE(edges.error().sentence.find("leave edges out"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum
