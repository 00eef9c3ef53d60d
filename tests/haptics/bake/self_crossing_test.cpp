// Surfaces that cross themselves: inside is what they wind around, and only its boundary is a surface.

#include "haptics/bake/mass_properties.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/winding.h"
#include "tests/haptics/bake/truth.h"

namespace fulcrum::test {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kHalfHeight = 0.01;  // m, of a prism's height
constexpr double kTube = 0.008;       // m, a tube's radius

// A closed line drawn out along z. Caps are fans about the middle, so that they overlap as the line does.
TriangleMesh prism(const std::vector<Vec2>& line) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(line.size());
  for (const Vec2& p : line) {
    mesh.vertices.emplace_back(p.x(), p.y(), -kHalfHeight);
    mesh.vertices.emplace_back(p.x(), p.y(), kHalfHeight);
  }
  mesh.vertices.emplace_back(0, 0, -kHalfHeight);
  mesh.vertices.emplace_back(0, 0, kHalfHeight);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    mesh.triangles.insert(mesh.triangles.end(),
                          {{a, b, b + 1}, {a, b + 1, a + 1}, {2 * n, b, a}, {2 * n + 1, a + 1, b + 1}});
  }
  return mesh;
}

// Exact, of the prism over a simple polygon.
double prism_truth(const std::vector<Vec2>& polygon, const Vec3& p) {
  const Vec2 q(p.x(), p.y());
  double nearest = 1e9;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double s = std::clamp((q - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (q - a - s * (b - a)).norm());
    if ((a.y() > q.y()) != (b.y() > q.y()) &&
        q.x() < a.x() + (q.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  const double beside = inside ? -nearest : nearest, above = std::abs(p.z()) - kHalfHeight;
  return std::hypot(std::max(beside, 0.0), std::max(above, 0.0)) + std::min(std::max(beside, above), 0.0);
}

Vec2 on_circle(double radius, double turns) {
  return radius * Vec2(std::cos(2.0 * std::numbers::pi * turns), std::sin(2.0 * std::numbers::pi * turns));
}

// A star drawn in one stroke winds twice around its middle; its outline is a decagon.
TEST(SelfCrossing, AStarOfOneStrokeIsItsOutline) {
  std::vector<Vec2> stroke, outline;
  const double inner = 0.03 * std::sin(std::numbers::pi / 10) / std::sin(7 * std::numbers::pi / 10);
  for (int i = 0; i < 5; ++i) {
    stroke.push_back(on_circle(0.03, 0.05 + 0.4 * i));
    outline.push_back(on_circle(0.03, 0.05 + 0.2 * i));
    outline.push_back(on_circle(inner, 0.15 + 0.2 * i));
  }
  const auto truth = [&](const Vec3& p) { return prism_truth(outline, p); };
  const TriangleMesh mesh = prism(stroke);
  const Solid solid = repaired(mesh);
  EXPECT_TRUE(tells(solid, "crosses itself")) << all_notes(solid);
  expect_distance(solid, truth, 1e-9);
  expect_field(solid, truth, 1e-3);

  double area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(mass_properties(solid).volume_m3, area * 2.0 * kHalfHeight, 1e-12);

  const auto shell = bake_pointshell(solid, {.spacing_m = 2e-3});
  ASSERT_TRUE(shell) << shell.error().sentence;
  for (const Vec3& p : shell->positions) ASSERT_NEAR(truth(p), 0.0, 1e-9);
}

// One lobe of an eight is wound the wrong way.
TEST(SelfCrossing, WhatIsInsideOutIsToldAndOutside) {
  const std::vector<Vec2> eight{{-0.02, -0.01}, {0.03, 0.015}, {0.03, -0.015}, {-0.02, 0.01}};
  const Solid solid = repaired(prism({eight[0], eight[3], eight[2], eight[1]}));
  EXPECT_TRUE(tells(solid, "inside out")) << all_notes(solid);
  const TriangleDistance exact(solid);
  const double left = exact.signed_distance(Vec3(-0.015, 0, 0)),
               right = exact.signed_distance(Vec3(0.015, 0, 0));
  EXPECT_LT(left * right, 0.0);
}

// A tube along a line that passes through itself. Outside, the distance to the line less the radius; inside,
// to the points of the tubes' surfaces that lie in no other part of it.
TEST(SelfCrossing, AKnottedTubeIsAUnion) {
  constexpr std::uint32_t n = 240, m = 48;
  const auto centre = [](double t) {
    return Vec3(0.05 * std::cos(t), 0.03 * std::sin(2 * t), 0.002 * std::sin(t));
  };
  TriangleMesh mesh;
  std::vector<Vec3> line;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double t = 2.0 * std::numbers::pi * i / n;
    const Vec3 along = (centre(t + 1e-5) - centre(t - 1e-5)).normalized();
    const Vec3 x = along.cross(Vec3::UnitZ()).normalized(), y = along.cross(x);
    line.push_back(centre(t));
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2.0 * std::numbers::pi * j / m;
      mesh.vertices.push_back(line.back() + kTube * (std::cos(a) * x + std::sin(a) * y));
      const std::uint32_t i1 = (i + 1) % n, j1 = (j + 1) % m;
      mesh.triangles.push_back({i * m + j, i * m + j1, i1 * m + j1});
      mesh.triangles.push_back({i * m + j, i1 * m + j1, i1 * m + j});
    }
  }
  const auto off_line = [&](const Vec3& p) {
    double least = 1e9;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec3 &a = line[i], &b = line[(i + 1) % line.size()];
      const double s = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - a - s * (b - a)).norm());
    }
    return least;
  };
  const Solid solid = repaired(mesh);
  ASSERT_EQ(solid.components.size(), 1u);
  EXPECT_TRUE(tells(solid, "crosses itself")) << all_notes(solid);
  std::vector<Vec3> surface, swallowed;
  for (const Vec3& p : mesh.vertices) (off_line(p) > kTube - 1e-4 ? surface : swallowed).push_back(p);
  const TriangleDistance exact(solid);
  int beside_swallowed = 0;
  for (const Vec3& p : places_about(solid, 3000)) {
    const double outside = off_line(p) - kTube, found = exact.signed_distance(p);
    if (std::abs(outside) > 1e-4) ASSERT_EQ(found < 0.0, outside < 0.0) << p.transpose();
    if (outside > 0.0) {
      ASSERT_NEAR(found, outside, 1e-4) << p.transpose();
      continue;
    }
    double depth = 1e9;
    for (const Vec3& q : surface) depth = std::min(depth, (p - q).norm());
    ASSERT_LE(-found, depth + 1e-4) << p.transpose();
    ASSERT_GE(-found, depth - 1.6e-3) << p.transpose();  // its points are up to as far apart
    const auto beside = [&](const Vec3& q) { return (p - q).norm() < 0.5 * depth; };
    beside_swallowed += std::any_of(swallowed.begin(), swallowed.end(), beside) ? 1 : 0;
  }
  EXPECT_GT(beside_swallowed, 8);
  expect_field(
      solid, [&](const Vec3& p) { return exact.signed_distance(p); }, 1e-3);
}

// Boxes that share an edge and pass through each other: welding makes one surface of them.
TEST(SelfCrossing, BoxesWeldedWhereTheyOverlapAreAUnion) {
  const Vec3 a1(0.04, 0.02, 0.02), b1(0.02, 0.04, 0.02);
  TriangleMesh mesh = shapes::box(Vec3::Zero(), a1);
  shapes::append(mesh, shapes::box(Vec3::Zero(), b1));
  const Solid solid = repaired(mesh);
  const TriangleDistance exact(solid);
  for (const Vec3& p : places_about(solid, 6000)) {
    const double truth =
        std::min(shapes::box_distance(p, Vec3::Zero(), a1), shapes::box_distance(p, Vec3::Zero(), b1));
    if (truth > 0.0)
      ASSERT_NEAR(exact.signed_distance(p), truth, 1e-12) << p.transpose();
    else
      ASSERT_LE(exact.signed_distance(p), 1e-12) << p.transpose();
  }
}

TEST(SelfCrossing, TouchingIsNotCrossing) {
  const Solid ring = repaired(shapes::torus(0.03, 0.01, 60, 24));
  EXPECT_TRUE(ring.notes.empty()) << all_notes(ring);
  EXPECT_TRUE(ring.components[0].shell.triangles.empty());
}

TEST(Winding, CountsHowOftenASurfaceGoesAround) {
  TriangleMesh mesh = shapes::sphere(Vec3::Zero(), 1.0, 30);
  shapes::append(mesh, shapes::sphere(Vec3(0.5, 0, 0), 1.0, 30));
  TriangleMesh inner = shapes::sphere(Vec3(2.5, 0, 0), 0.5, 30);
  for (Triangle& t : inner.triangles) std::swap(t[0], t[1]);
  shapes::append(mesh, inner);
  const Winding winding(mesh);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> anywhere(-1.5, 3.5);
  const auto in = [](const Vec3& p, double x, double r) { return (p - Vec3(x, 0, 0)).norm() - r; };
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(anywhere(random), anywhere(random), anywhere(random));
    const double a = in(p, 0, 1), b = in(p, 0.5, 1), c = in(p, 2.5, 0.5);
    if (std::min({std::abs(a), std::abs(b), std::abs(c)}) < 0.01) continue;
    ASSERT_EQ(winding.around(p), (a < 0) + (b < 0) - (c < 0)) << p.transpose();
  }
}

}  // namespace
}  // namespace fulcrum::test
