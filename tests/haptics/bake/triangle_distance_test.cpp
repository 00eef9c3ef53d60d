#include "haptics/bake/triangle_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

class Points {
public:
  explicit Points(double reach) : coordinate_(-reach, reach) {}
  Vec3 next() {
    const double x = coordinate_(random_), y = coordinate_(random_), z = coordinate_(random_);
    return {x, y, z};
  }

private:
  std::mt19937_64 random_{7};
  std::uniform_real_distribution<double> coordinate_;
};

TEST(TriangleDistance, BoxIsExactNearFacesEdgesAndCorners) {
  const Vec3 low(-0.5, -1.0, -0.25), high(0.5, 1.0, 0.75);
  const Quat q = Quat(0.8, 0.3, -0.4, 0.2).normalized();
  const auto solid = build_solid(shapes::rotated(shapes::box(low, high), q));
  ASSERT_TRUE(solid);
  const TriangleDistance exact(*solid);
  Points points(2.0);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = points.next();
    ASSERT_NEAR(exact.signed_distance(q * p), shapes::box_distance(p, low, high), 1e-12);
  }
}

// A needle-sharp tetrahedron: where face normals of the closest triangle alone would give the wrong sign.
TEST(TriangleDistance, SignIsRightAroundSharpCorners) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.1, 0, 1}, {-0.05, 0.08, 1}, {-0.05, -0.08, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  const auto solid = build_solid(mesh);
  ASSERT_TRUE(solid) << solid.error().sentence;
  const TriangleDistance exact(*solid);
  Points points(1.5);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = points.next();
    double beyond = -1e9;  // of the four planes
    for (const Triangle& t : mesh.triangles) {
      const Vec3& a = mesh.vertices[t[0]];
      beyond = std::max(beyond,
                        (p - a).dot((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized()));
    }
    ASSERT_EQ(exact.signed_distance(p) < 0.0, beyond < 0.0) << p.transpose();
  }
}

TEST(TriangleDistance, UnionIsTheLeastOfItsComponents) {
  const Vec3 a0(-1, -1, -1), a1(0.3, 0.4, 0.5), b0(-0.2, -0.3, -0.6), b1(1, 1.2, 0.9), c0(-0.1, -0.1, -0.1),
      c1(0.1, 0.1, 0.1);
  TriangleMesh mesh = shapes::box(a0, a1);
  shapes::append(mesh, shapes::box(b0, b1));
  shapes::append(mesh, shapes::box(c0, c1));  // buried in both
  const auto solid = build_solid(mesh);
  ASSERT_TRUE(solid);
  ASSERT_EQ(solid->components.size(), 3u);
  const TriangleDistance exact(*solid);
  Points points(1.6);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = points.next();
    const double expected = std::min(
        {shapes::box_distance(p, a0, a1), shapes::box_distance(p, b0, b1), shapes::box_distance(p, c0, c1)});
    ASSERT_NEAR(exact.signed_distance(p), expected, 1e-12) << p.transpose();
    ASSERT_NEAR(exact.signed_distance_within(p, 0.2), std::min(expected, 0.2), 1e-12);
    const ClosestPoint closest = exact.closest(p);
    ASSERT_NEAR((closest.point - p).norm(), std::abs(expected), 1e-12);
    ASSERT_GE((p - closest.point).dot(closest.normal) * expected, 0.0);
  }
}

TEST(TriangleDistance, AHintChangesNothing) {
  const auto solid = build_solid(shapes::torus(1.0, 0.3, 60, 30));
  ASSERT_TRUE(solid);
  const TriangleDistance exact(*solid);
  Points points(1.5);
  std::uint32_t wandering = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = points.next();
    std::uint32_t fresh = 0;
    const double with_wandering = exact.component_distance(0, p, wandering);
    ASSERT_EQ(with_wandering, exact.component_distance(0, p, fresh));
    ASSERT_EQ(wandering, fresh);
  }
}

TEST(TriangleDistance, NoPathSlipsBetweenTriangles) {
  const auto solid = build_solid(shapes::sphere(Vec3::Zero(), 1.0, 8));
  ASSERT_TRUE(solid);
  const TriangleDistance exact(*solid);
  const auto enters = [&](const Vec3& from, const Vec3& to) {
    const auto crossing = exact.first_crossing(from, to);
    return crossing && crossing->entering;
  };
  for (const Triangle& t : solid->mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = solid->mesh.vertices[t[i]], &b = solid->mesh.vertices[t[(i + 1) % 3]];
      for (const double s : {0.0, 0.1, 1.0 / 3.0, 0.5, 0.9}) {
        const Vec3 target = a + s * (b - a);  // on an edge or a vertex
        EXPECT_TRUE(enters(2.0 * target, Vec3::Zero()));
        EXPECT_FALSE(enters(Vec3::Zero(), 2.0 * target));
        EXPECT_TRUE(exact.first_crossing(Vec3::Zero(), 2.0 * target));
      }
    }
  }
}

TEST(TriangleDistance, TheFirstCrossingIsFirst) {
  TriangleMesh mesh = shapes::box(Vec3(0, -1, -1), Vec3(1, 1, 1));
  shapes::append(mesh, shapes::box(Vec3(3, -1, -1), Vec3(4, 1, 1)));
  const auto solid = build_solid(mesh);
  ASSERT_TRUE(solid);
  const TriangleDistance exact(*solid);
  const auto there = exact.first_crossing(Vec3(-1, 0.1, 0.2), Vec3(5, 0.1, 0.2));
  ASSERT_TRUE(there);
  EXPECT_NEAR(there->fraction, 1.0 / 6.0, 1e-15);
  EXPECT_TRUE(there->entering);
  const auto out = exact.first_crossing(Vec3(0.5, 0.1, 0.2), Vec3(5, 0.1, 0.2));
  ASSERT_TRUE(out);
  EXPECT_FALSE(out->entering);
  EXPECT_FALSE(exact.first_crossing(Vec3(1.5, 0, 0), Vec3(2.5, 0.5, 0)));
  EXPECT_FALSE(exact.first_crossing(Vec3(-1, 0, 0), Vec3(-0.001, 0, 0)));
  const auto second = exact.first_crossing_of(1, Vec3(-1, 0.1, 0.2), Vec3(5, 0.1, 0.2));
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->fraction, 4.0 / 6.0, 1e-15);
}

}  // namespace
}  // namespace fulcrum
