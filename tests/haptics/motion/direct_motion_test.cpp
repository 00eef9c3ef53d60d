// Direct rendering: the tool where the hand wants it, and a spring from each region's deepest point.

#include "haptics/motion/direct_motion.h"

#include <gtest/gtest.h>

#include <numbers>

#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"
#include "tests/haptics/world/stick.h"

namespace fulcrum::test {
namespace {

Pose stick_pose(const SceneDesc& desc, double height) {
  Pose X_WT = desc.tool.X_WT_start;
  X_WT.p.y() = kBallRadius + height;
  return X_WT;
}

// Of a sphere the deepest point of a stick that lies across it is the one over its centre.
TEST(DirectMotion, ForceIsStiffnessTimesDepthAtTheDeepestPoint) {
  for (const double touched : {0.02, 0.1, 0.18}) {
    const SceneDesc desc = stick_scene(touched, 0.1);
    DirectMotion motion(desc);
    std::uint32_t faults = 0;
    for (const double depth : {0.1e-3, 1e-3, 4e-3, 8e-3}) {
      const Pose X_WG = stick_pose(desc, -depth);
      const ToolAnswer answer = motion.advance(X_WG, {}, faults);
      EXPECT_EQ(answer.X_WT.p, X_WG.p);
      ASSERT_EQ(motion.regions().size(), 1u);
      const Vec3 force(0, 300 * depth, 0);
      EXPECT_NEAR((answer.contact_F_T_W.force - force).norm(), 0, 300 * 8e-6) << depth;  // of the lattice
      const Vec3 lever(touched - 0.1, 0, 0);
      EXPECT_NEAR((answer.contact_F_T_W.torque - lever.cross(force)).norm(), 0, 300 * 8e-6) << depth;
      EXPECT_NEAR(motion.stored_energy(), 0.5 * 300 * depth * depth, 300 * 8e-6 * depth);
      EXPECT_EQ(answer.coupling_F_T_W.force, -answer.contact_F_T_W.force);
    }
    EXPECT_EQ(faults, 0u);
  }
}

// The wrench is the gradient of the energy: along any path what is put in comes back.
TEST(DirectMotion, GivesBackWhatWasPutIn) {
  const SceneDesc desc = stick_scene(0.1, 0.1);
  DirectMotion motion(desc);
  std::uint32_t faults = 0;
  double work = 0, most = 0;
  Pose before;
  Wrench F_before;
  constexpr int n = 20000;
  for (int i = 0; i <= n; ++i) {
    const double s = 2 * std::numbers::pi * i / n;
    Pose X_WG = stick_pose(desc, 2e-3 - 5e-3 * std::sin(s));
    X_WG.p.x() += 3e-3 * (1 - std::cos(s));
    X_WG.q = Quat(Eigen::AngleAxisd(0.05 * std::sin(2 * s), Vec3::UnitZ()));
    const Wrench F = motion.advance(X_WG, {}, faults).coupling_F_T_W;
    if (i > 0) {
      const Vec3 turned = rotation_vector(X_WG.q * before.q.conjugate());
      work += 0.5 *
              ((F.force + F_before.force).dot(X_WG.p - before.p) + (F.torque + F_before.torque).dot(turned));
    }
    most = std::max(most, motion.stored_energy());
    EXPECT_NEAR(work, motion.stored_energy(), 1e-5) << i;
    before = X_WG;
    F_before = F;
  }
  EXPECT_GT(most, 1e-3);
  EXPECT_NEAR(work, 0, 1e-6);
}

// A pressed spring keeps its stiffness, or it would make energy.
TEST(DirectMotion, IsStiffenedWhereNothingTouches) {
  const SceneDesc desc = stick_scene(0.1, 0.1);
  DirectMotion motion(desc);
  std::uint32_t faults = 0;
  motion.advance(stick_pose(desc, -1e-3), {}, faults);
  EXPECT_FALSE(motion.stiffen(600));
  EXPECT_NEAR(motion.advance(stick_pose(desc, -2e-3), {}, faults).contact_F_T_W.force.y(), 0.6, 3e-3);
  motion.advance(stick_pose(desc, 1e-3), {}, faults);
  EXPECT_TRUE(motion.stiffen(600));
  EXPECT_NEAR(motion.advance(stick_pose(desc, -2e-3), {}, faults).contact_F_T_W.force.y(), 1.2, 6e-3);
}

// Past the band of its field a depth is a guess: that stops the force, as under every response.
TEST(DirectMotion, TooDeepIsAFault) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.01);
  desc.contact.response = ContactResponse::direct;
  DirectMotion motion(desc);
  std::uint32_t faults = 0;
  motion.advance({Quat::Identity(), Vec3(0, -5e-3, 0)}, {}, faults);
  EXPECT_EQ(faults & kToolInside, 0u);
  motion.advance({Quat::Identity(), Vec3(0, -20e-3, 0)}, {}, faults);
  EXPECT_NE(faults & kToolInside, 0u);
}

TEST(DirectMotion, TwoPlacesHaveASpringEach) {
  SceneDesc desc = floor_scene({Vec3(-0.04, 0, 0), Vec3(0.04, 0, 0)}, 0.01);
  desc.contact.response = ContactResponse::direct;
  desc.contact.stiffness = 200;
  DirectMotion motion(desc);
  std::uint32_t faults = 0;
  const Pose X_WG{Quat(Eigen::AngleAxisd(0.025, Vec3::UnitZ())), Vec3(0, -2e-3, 0)};
  const ToolAnswer answer = motion.advance(X_WG, {}, faults);
  const double up = 0.04 * std::sin(0.025), aside = 0.04 * std::cos(0.025);
  EXPECT_EQ(motion.regions().size(), 2u);
  EXPECT_NEAR(answer.contact_F_T_W.force.y(), 200 * 4e-3, 200 * 1e-6);
  EXPECT_NEAR(answer.contact_F_T_W.torque.z(), 200 * aside * ((2e-3 - up) - (2e-3 + up)), 200 * 0.04 * 1e-6);
}

}  // namespace
}  // namespace fulcrum::test
