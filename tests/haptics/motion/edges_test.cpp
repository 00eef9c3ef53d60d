// A knife edge of the scene under a tool whose points all lie beside it: what the shell alone cannot feel.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "haptics/bake/pointshell_bake.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

constexpr double kHalf = 0.01;  // m, of the block, which is as high as it is wide

const Solid& block() {
  static const Solid solid = expect(build_solid(box_mesh(Vec3::Constant(-kHalf), Vec3::Constant(kHalf))));
  return solid;
}

// A ridge along z with its edge at y = 0, 60 degrees sharp.
const Solid& ridge() {
  static const Solid solid = [] {
    TriangleMesh mesh;
    for (const double z : {-0.05, 0.05})
      for (const Vec3& corner : {Vec3(0, 0, z), Vec3(-0.02, -0.0346, z), Vec3(0.02, -0.0346, z)})
        mesh.vertices.push_back(corner);
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return expect(build_solid(mesh));
  }();
  return solid;
}

SceneDesc scene(bool edges) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1 ? 1 : -1) * kHalf, (i & 2 ? 1 : -1) * kHalf, (i & 4 ? 1 : -1) * kHalf);
  SceneDesc desc = floor_scene(corners, 0.03);
  desc.contact.response = ContactResponse::constraint;
  desc.coupling.max_force = 5000;
  desc.coupling.max_torque = 500;
  desc.scene_field =
      std::make_shared<DistanceField>(expect(bake_field(ridge(), {.voxel_m = 1e-3, .band_m = 4e-3})));
  if (edges) {
    desc.scene_edges = std::make_shared<Pointshell>(expect(bake_edges(ridge(), {.spacing_m = 1e-3})));
    desc.tool_field =
        std::make_shared<DistanceField>(expect(bake_field(block(), {.voxel_m = 1e-3, .band_m = 4e-3})));
  }
  return desc;
}

Pose at_height(double y) {
  return {Quat::Identity(), Vec3(0, y, 0)};
}

TEST(SceneEdges, AFlatToolRestsOnAKnifeEdge) {
  World world = expect(World::build(scene(true)));
  hold(world, at_height(0.03), 50);
  const TickRecord record = hold(world, at_height(kHalf - 5e-3), 800).record;
  EXPECT_NEAR(record.X_WT.p.y(), kHalf, 5e-6);
  EXPECT_NEAR(record.contact_F_T_W.force.y(), 800 * 5e-3, 0.04);
  EXPECT_NEAR(record.contact_F_T_W.force.x(), 0, 0.01);
  EXPECT_LT(record.depth_max, 5e-6);
  EXPECT_GE(record.regions, 1);
  EXPECT_EQ(record.faults & kStoppingFaults, 0u);
}

TEST(SceneEdges, WithoutThemItSinksInBetweenItsPoints) {
  World world = expect(World::build(scene(false)));
  hold(world, at_height(0.03), 50);
  EXPECT_LT(hold(world, at_height(kHalf - 5e-3), 800).record.X_WT.p.y(), kHalf - 4e-3);
}

// Slowly and at up to 100 m/s, spinning: the edge never gets farther into the block than a motion may take
// it.
TEST(SceneEdges, NoMotionTakesTheToolOverTheEdge) {
  const SceneDesc desc = scene(true);
  World world = expect(World::build(desc));
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::normal_distribution<double> normal;
  double deepest = 0;
  int touched = 0;
  for (int i = 0; i < 4000; ++i) {
    const Quat q = Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
    const Vec3 p(0.02 * unit(random), i % 2 == 0 ? 0.02 + 0.03 * std::abs(unit(random)) : 0.02 * unit(random),
                 0.02 * unit(random));
    for (int tick = 0; tick < 3; ++tick) {
      const TickRecord record = step(world, at({q, p}), {}).record;
      const Pose X_TW = record.X_WT.inverse();
      for (const Vec3& p_W : desc.scene_edges->positions) {
        const Vec3 p_T = X_TW * p_W;
        deepest = std::max(deepest, kHalf - p_T.cwiseAbs().maxCoeff());
      }
      touched += record.regions > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(touched, 2000);
  EXPECT_LT(deepest, 0.6e-3);
}

TEST(SceneEdges, NeedAFieldOfTheToolAndAConstraint) {
  SceneDesc half = scene(true);
  half.tool_field = nullptr;
  EXPECT_FALSE(World::build(half));
  SceneDesc springs = scene(true);
  springs.contact.response = ContactResponse::penalty;
  const auto built = World::build(springs);
  ASSERT_FALSE(built);
  EXPECT_NE(built.error().sentence.find("constraint"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::test
