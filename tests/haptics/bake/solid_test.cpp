#include "haptics/bake/solid.h"

#include <gtest/gtest.h>

#include <limits>

#include "haptics/bake/mass_properties.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

std::string refusal(const TriangleMesh& mesh) {
  const auto solid = build_solid(mesh);
  return solid ? "" : solid.error().sentence;
}

bool mentions(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

TriangleMesh unit_box() {
  return shapes::box(Vec3::Zero(), Vec3::Ones());
}

// Every triangle with vertices of its own, as exporters write flat-shaded models.
TriangleMesh unshared(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (const std::uint32_t v : t) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TEST(Solid, WeldsASoup) {
  TriangleMesh soup = unshared(unit_box());
  soup.vertices[0] = soup.vertices[0] * -1.0;  // -0 is where 0 is
  const auto solid = build_solid(soup);
  ASSERT_TRUE(solid) << solid.error().sentence;
  EXPECT_EQ(solid->mesh.vertices.size(), 8u);
  ASSERT_EQ(solid->components.size(), 1u);
  EXPECT_NEAR(solid->components[0].volume_m3, 1.0, 1e-15);
}

TEST(Solid, NeighboursShareTheirEdge) {
  const auto solid = build_solid(shapes::torus(1.0, 0.3, 24, 12));
  ASSERT_TRUE(solid);
  for (std::uint32_t t = 0; t < solid->mesh.triangles.size(); ++t) {
    for (std::size_t e = 0; e < 3; ++e) {
      const Triangle& here = solid->mesh.triangles[t];
      const Triangle& there = solid->mesh.triangles[solid->neighbours[t][e]];
      int shared = 0;
      for (const std::uint32_t v : there) shared += v == here[e] || v == here[(e + 1) % 3] ? 1 : 0;
      EXPECT_EQ(shared, 2);
    }
  }
}

TEST(Solid, SeparateBodiesAreComponents) {
  TriangleMesh mesh = unit_box();
  shapes::append(mesh, shapes::box(Vec3(3, 0, 0), Vec3(5, 1, 1)));
  const auto solid = build_solid(mesh);
  ASSERT_TRUE(solid);
  ASSERT_EQ(solid->components.size(), 2u);
  EXPECT_NEAR(solid->components[1].volume_m3, 2.0, 1e-14);
  EXPECT_EQ(solid->components[1].first_triangle, 12u);
}

// Stacked, side by side along an edge, and corner to corner: welding joins them, pairing takes them apart
// again.
TEST(Solid, BodiesThatTouchStayApart) {
  for (const Vec3& offset : {Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(1, 1, 1)}) {
    TriangleMesh mesh = unit_box();
    shapes::append(mesh, shapes::box(offset, offset + Vec3::Ones()));
    const auto solid = build_solid(mesh);
    ASSERT_TRUE(solid) << solid.error().sentence;
    ASSERT_EQ(solid->components.size(), 2u);
    EXPECT_EQ(solid->mesh.vertices.size(), 16u);
    for (const SolidComponent& component : solid->components) EXPECT_NEAR(component.volume_m3, 1.0, 1e-14);
  }
}

TEST(Solid, CollapsedTrianglesAreDroppedAndCounted) {
  TriangleMesh mesh = unit_box();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({2, 3, 3});
  const auto solid = build_solid(mesh);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->dropped_triangles, 2u);
}

TEST(Solid, AWideHoleIsRefusedWithItsPlace) {
  TriangleMesh mesh = unit_box();
  mesh.triangles.pop_back();
  const std::string sentence = refusal(mesh);
  EXPECT_TRUE(mentions(sentence, "A hole about 707.1 mm wide around (0.3333, 0.6667, 1) m")) << sentence;
  EXPECT_TRUE(mentions(sentence, "(433 mm here)")) << sentence;
}

TEST(Solid, ASheetWithTwoSidesIsRefused) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_TRUE(mentions(refusal(mesh), "no volume")) << refusal(mesh);
}

TEST(Solid, NothingAndNonsenseAreRefused) {
  EXPECT_TRUE(mentions(refusal({}), "no triangles"));
  TriangleMesh mesh = unit_box();
  mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(mentions(refusal(mesh), "Vertex 5 of the mesh is not a finite number")) << refusal(mesh);
  mesh = unit_box();
  mesh.triangles[7][2] = 8;
  EXPECT_TRUE(mentions(refusal(mesh), "Triangle 7 refers to vertex 8 of 8")) << refusal(mesh);
  mesh = unit_box();
  mesh.vertices.assign(8, Vec3::Ones());
  EXPECT_TRUE(mentions(refusal(mesh), "All 12 triangles")) << refusal(mesh);
}

TEST(MassProperties, OfABoxAwayFromTheOrigin) {
  const Vec3 size(0.1, 0.2, 0.4), low(5.0, -3.0, 2.0);
  const auto solid = build_solid(shapes::box(low, low + size));
  ASSERT_TRUE(solid);
  const MassProperties mass = mass_properties(*solid);
  const double volume = size.prod();
  EXPECT_NEAR(mass.volume_m3, volume, 1e-12 * volume);
  EXPECT_NEAR((mass.centre - low - 0.5 * size).norm(), 0.0, 1e-13);
  for (int axis = 0; axis < 3; ++axis) {
    const double a = size[(axis + 1) % 3], b = size[(axis + 2) % 3];
    EXPECT_NEAR(mass.inertia(axis, axis), volume * (a * a + b * b) / 12.0, 1e-14);
    EXPECT_NEAR(mass.inertia(axis, (axis + 1) % 3), 0.0, 1e-14);
  }
}

TEST(MassProperties, OfASphereConvergeToTheBalls) {
  const auto solid = build_solid(shapes::sphere(Vec3(1, 2, 3), 0.5, 160));
  ASSERT_TRUE(solid);
  const MassProperties mass = mass_properties(*solid);
  const double volume = 4.0 / 3.0 * std::numbers::pi * 0.125;
  EXPECT_NEAR(mass.volume_m3, volume, 1e-3 * volume);
  EXPECT_NEAR(mass.inertia(0, 0), 0.4 * volume * 0.25, 1e-3 * 0.4 * volume * 0.25);
}

}  // namespace
}  // namespace fulcrum
