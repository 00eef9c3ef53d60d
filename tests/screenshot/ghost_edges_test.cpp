// Which edges of a mesh are drawn, against solids whose edges can be counted on paper.

#include "engine/render/ghost_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_scene.h"

namespace fulcrum::render {
namespace {

VisualDesc of(const Mesh& mesh) {
  VisualDesc desc;
  desc.meshes = {mesh};
  desc.materials = {{}};
  desc.instances = {{.name = "", .movable = true}};
  return desc;
}

std::vector<gpu::GhostLine> chosen(GhostEdges& edges, const glm::vec3& p_GE) {
  std::vector<gpu::GhostLine> lines(edges.size());
  lines.resize(edges.choose(p_GE, lines.data()));
  return lines;
}

TEST(GhostEdges, ABoxHasTwelveCreasesAndShowsNineOrFour) {
  GhostEdges edges(of(test::make_box({1.0F, 1.0F, 1.0F})), Ghost{});
  EXPECT_EQ(edges.creases(), 12U);
  EXPECT_EQ(edges.boundaries(), 0U);
  EXPECT_EQ(edges.size(), 12U + 6U);  // a diagonal in each face
  EXPECT_EQ(chosen(edges, {3.0F, 4.0F, 5.0F}).size(), 9U);
  EXPECT_EQ(chosen(edges, {0.0F, 0.0F, 5.0F}).size(), 4U);
}

// The test's sphere has a seam and poles whose vertices lie in one place but for rounding.
TEST(GhostEdges, ASphereShowsItsOutlineAlone) {
  GhostEdges edges(of(test::make_ball(1.0F)), Ghost{});
  EXPECT_EQ(edges.creases(), 0U);
  EXPECT_EQ(edges.boundaries(), 0U);
  const glm::vec3 eye(0.0F, 0.0F, 4.0F);
  const std::vector<gpu::GhostLine> lines = chosen(edges, eye);
  EXPECT_GE(lines.size(), 48U);  // once around
  EXPECT_LE(lines.size(), 150U);
  for (const gpu::GhostLine& line : lines) {
    // A sphere's outline lies where the line of sight touches it: at 1 / 4 of the way to the eye, to within a
    // facet.
    EXPECT_NEAR(line.from.z, 0.25F, 0.14F);
  }
}

TEST(GhostEdges, ASheetShowsItsFourBoundariesFromBothSides) {
  Mesh sheet;
  sheet.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  sheet.normals.assign(4, {0, 0, 1});
  sheet.indices = {0, 1, 2, 0, 2, 3};
  GhostEdges edges(of(sheet), Ghost{});
  EXPECT_EQ(edges.boundaries(), 4U);
  EXPECT_EQ(edges.creases(), 0U);
  EXPECT_EQ(chosen(edges, {0, 0, 2}).size(), 4U);
  EXPECT_EQ(chosen(edges, {0, 0, -2}).size(), 4U);
}

TEST(GhostEdges, TheCreaseAngleDecides) {
  VisualDesc desc = of(test::make_box({1.0F, 1.0F, 1.0F}));
  GhostEdges edges(desc, {.crease_rad = 1.6F});  // more than a right angle
  EXPECT_EQ(edges.creases(), 0U);
  EXPECT_EQ(chosen(edges, {3.0F, 4.0F, 5.0F}).size(), 6U);  // the outline
}

TEST(GhostEdges, OnlyWhatMovesIsCopiedAndEachMeshOnce) {
  VisualDesc desc = of(test::make_box({1.0F, 1.0F, 1.0F}));
  desc.meshes.push_back(test::make_ball(1.0F));
  desc.instances.push_back({.mesh = 1, .name = ""});
  desc.instances.push_back({.name = "", .movable = true});
  EXPECT_EQ(GhostEdges(desc, Ghost{}).size(), 18U);
}

}  // namespace
}  // namespace fulcrum::render
