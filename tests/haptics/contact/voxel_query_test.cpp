#include "haptics/contact/voxel_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

// A point that goes down into a floor: its depth is right to half a voxel's diagonal, and no better.
TEST(VoxelQuery, DepthIsRightToHalfADiagonalAndJumps) {
  const double voxel = 2e-3;
  const auto shell = shell_of({Vec3(0, -1e-6, 0)});  // its normal points down
  VoxelQuery query(shell, floor_field());
  ContactSet set;
  double worst = 0, jump = 0, before = 0;
  for (double depth = 0.1e-3; depth < 7e-3; depth += 0.05e-3) {
    query.run({Quat::Identity(), Vec3(0.0123, -depth, 0.0077)}, set);
    const double seen = set.depth_max();
    worst = std::max(worst, std::abs(seen - depth));
    jump = std::max(jump, std::abs(seen - before));
    before = seen;
  }
  EXPECT_LT(worst, 0.5 * std::sqrt(3.0) * voxel);
  EXPECT_GT(worst, 0.1 * voxel);
  EXPECT_GT(jump, 0.5 * voxel);
  query.run({Quat::Identity(), Vec3(0, 0.01, 0)}, set);
  EXPECT_TRUE(set.contacts().empty());
}

TEST(VoxelQuery, ASceneCanNameIt) {
  SceneDesc desc = floor_scene({Vec3(0, -1e-6, 0)}, 0.02);
  desc.contact.response = ContactResponse::voxel;
  desc.integrator = Integrator::implicit_euler;
  World world = expect(World::build(desc));
  hold(world, {Quat::Identity(), Vec3(0, 0.02, 0)}, 700);
  const Pose pushed{Quat::Identity(), Vec3(0, -5e-3, 0)};
  hold(world, pushed, 1000);
  // Its depth jumps from voxel to voxel and the tool may chatter; in the mean it holds the hand.
  double force = 0, deepest = 0;
  for (int i = 0; i < 500; ++i) {
    const TickRecord record = step(world, at(pushed), {}).record;
    force += record.contact_F_T_W.force.y() / 500;
    deepest = std::max(deepest, -record.X_WT.p.y());
  }
  EXPECT_GT(force, 1);
  EXPECT_LT(deepest, 2e-3);
}

}  // namespace
}  // namespace fulcrum::test
