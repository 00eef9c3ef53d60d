// Which vertices and edges of a surface can touch another, and with which normals.

#include "haptics/geometry/feature_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/math/rotation.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

FeatureMesh features(const TriangleMesh& mesh) {
  const Solid solid = shapes::solid_of(mesh);
  return {solid.mesh, solid.neighbours};
}

std::ptrdiff_t touching(const FeatureMesh& mesh) {
  return std::ranges::count_if(
      mesh.vertex_normals(), [](const NormalCone& cone) { return !cone.none(); });
}

TEST(FeatureMesh, EachFeatureIsOfOneFace) {
  for (const TriangleMesh& of :
       {shapes::torus(0.01, 0.004, 9, 6), shapes::grid_box(Vec3::Zero(), Vec3::Ones(), 3)}) {
    const FeatureMesh mesh = features(of);
    std::size_t corners = 0, edges = 0;
    for (const FeatureMesh::Face& face : mesh.faces()) {
      for (unsigned i = 0; i < 3; ++i) {
        corners += face.own_corners >> i & 1u;
        edges += face.own_edges >> i & 1u;
      }
    }
    EXPECT_EQ(corners, mesh.vertices().size());
    EXPECT_EQ(edges, mesh.edges().size());
    EXPECT_EQ(2 * edges, 3 * mesh.faces().size());
  }
}

TEST(FeatureMesh, ABoxTouchesWithItsCornersHoweverManyVerticesItsSidesHave) {
  const Vec3 low(-0.003, -0.001, -0.007), high(0.002, 0.001, 0.006);
  for (const TriangleMesh& of : {shapes::box(low, high), shapes::grid_box(low, high, 4)}) {
    const FeatureMesh mesh = features(of);
    EXPECT_EQ(touching(mesh), 8);
    EXPECT_NEAR(mesh.radius(), low.norm(), 1e-15);
    for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
      const NormalCone& cone = mesh.vertex_normals()[v];
      if (cone.none()) continue;
      // The corner's three sides' normals.
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 side = Vec3::Unit(axis) * (mesh.vertices()[v][axis] > 0 ? 1 : -1);
        EXPECT_LE(angle_between(cone.axis(), side), cone.angle() + 1e-9);
      }
      EXPECT_LT(cone.angle(), 1.0);  // acos(1 / sqrt(3)) = 0.955
    }
  }
  const FeatureMesh mesh = features(shapes::box(low, high));
  EXPECT_EQ(std::ranges::count_if(mesh.edges(), &FeatureMesh::Edge::convex), 12);
  EXPECT_EQ(std::ranges::count_if(mesh.edges(), &FeatureMesh::Edge::flat), 6);
}

// m, from the axis of shapes::torus.
double across(const Vec3& p) {
  return std::hypot(p.x(), p.z());
}

TEST(FeatureMesh, NothingTouchesWithTheInsideOfARing) {
  constexpr double R = 0.01;
  const FeatureMesh mesh = features(shapes::torus(R, 0.004, 16, 12));
  int inside = 0, outside = 0;
  for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
    const double from_axis = across(mesh.vertices()[v]);
    if (from_axis < 0.8 * R) {
      EXPECT_TRUE(mesh.vertex_normals()[v].none());
      ++inside;
    } else if (from_axis > 1.2 * R) {
      EXPECT_FALSE(mesh.vertex_normals()[v].none());
      ++outside;
    }
  }
  EXPECT_GT(inside, 10);
  EXPECT_GT(outside, 10);
}

TEST(FeatureMesh, AFineSphereTouchesWithAllOfItsVertices) {
  const FeatureMesh mesh = features(shapes::sphere(Vec3::Zero(), 0.01, 5));
  EXPECT_EQ(touching(mesh), static_cast<std::ptrdiff_t>(mesh.vertices().size()));
}

// An edge of a box ends in the open, on both sides, or where its next part begins; nothing of a box rises
// beside its faces.
TEST(FeatureMesh, ABoxGoesOnNowhere) {
  for (const TriangleMesh& of :
       {shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::grid_box(Vec3::Zero(), Vec3::Ones(), 4),
        shapes::sphere(Vec3::Zero(), 1, 3)}) {
    const FeatureMesh mesh = features(of);
    EXPECT_TRUE(std::ranges::all_of(
        mesh.edges(), [](const auto& edge) { return edge.goes_on == 0; }));
    EXPECT_TRUE(std::ranges::all_of(mesh.faces(), [](const auto& face) {
      return face.rises_at_edges == 0 && face.rises_at_corners == 0;
    }));
  }
}

// A bar along z from 0 to 2, with a groove along its top.
TriangleMesh grooved_bar() {
  TriangleMesh bar;
  constexpr std::array<std::array<double, 2>, 7> kOutline{
      {{-1, -1}, {1, -1}, {1, 0}, {0.5, 0}, {0, -0.5}, {-0.5, 0}, {-1, 0}}};
  constexpr auto n = static_cast<std::uint32_t>(kOutline.size());
  for (const double z : {0.0, 1.0, 2.0})
    for (const auto& [x, y] : kOutline) bar.vertices.emplace_back(x, y, z);
  for (const double z : {0.0, 2.0}) bar.vertices.emplace_back(0, -0.75, z);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    for (const std::uint32_t section : {0u, n}) {
      const std::uint32_t a = section + i, b = section + next;
      bar.triangles.push_back({a, b, b + n});
      bar.triangles.push_back({a, b + n, a + n});
    }
    bar.triangles.push_back({next, i, 3 * n});
    bar.triangles.push_back({2 * n + i, 2 * n + next, 3 * n + 1});
  }
  return bar;
}

// In the groove, the surface rises beyond a corner at the bottom; at the groove's ends there is nothing.
TEST(FeatureMesh, AGrooveRisesBetweenItsEndsAlone) {
  const FeatureMesh mesh = features(grooved_bar());
  int rising = 0;
  for (const FeatureMesh::Face& face : mesh.faces())
    for (unsigned i = 0; i < 3; ++i) {
      if ((face.rises_at_corners >> i & 1u) == 0) continue;
      EXPECT_LT((mesh.vertices()[face.corners[i]] - Vec3(0, -0.5, 1)).norm(), 1e-12);
      ++rising;
    }
  EXPECT_GE(rising, 2) << "one of each wall at least";
}

// Around a ring's hole the surface rises beside the faces, and on the ring's outside beside none.
TEST(FeatureMesh, ARingRisesInItsHoleAlone) {
  constexpr double R = 0.01;
  const FeatureMesh mesh = features(shapes::torus(R, 0.004, 16, 12));
  int inside = 0, outside = 0;
  for (const FeatureMesh::Face& face : mesh.faces()) {
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t v : face.corners) middle += mesh.vertices()[v] / 3;
    if (across(middle) < 0.9 * R) {
      EXPECT_NE(face.rises_at_edges, 0);
      ++inside;
    } else if (across(middle) > 1.1 * R) {
      EXPECT_EQ(face.rises_at_edges, 0);
      ++outside;
    }
  }
  EXPECT_GT(inside, 10);
  EXPECT_GT(outside, 10);
}

}  // namespace
}  // namespace fulcrum
