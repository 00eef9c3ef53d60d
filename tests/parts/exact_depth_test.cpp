// Truths: boxes and edges whose overlap is known by hand, at any pose.

#include "tests/parts/exact_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/math/rotation.h"
#include "tests/parts/flat.h"

namespace fulcrum::parts {
namespace {

constexpr double kSpacing = 0.25e-3;

TriangleMesh box(const Vec3& half) {
  return extruded(columns({-half.x(), half.x()}, {-half.y()}, {half.y()}), -half.z(), half.z());
}

// A bar along z of a square section that stands on its edge, r m below and above its middle.
TriangleMesh bar_on_edge(double r) {
  return extruded(star({{r, 0}, {0, r}, {-r, 0}, {0, -r}}), -2.5 * r, 2.5 * r);
}

TEST(ExactDepth, OfBoxesIsTheirOverlap) {
  const ExactDepth depth(box(Vec3(1e-3, 2e-3, 3e-3)), box(Vec3(4e-3, 5e-3, 6e-3)), kSpacing);
  EXPECT_EQ(depth.at({Quat::Identity(), Vec3(5.001e-3, 0, 0)}), 0);
  EXPECT_NEAR(depth.at({Quat::Identity(), Vec3(4.99e-3, 0, 0)}), 10e-6, 1e-12);
  EXPECT_NEAR(depth.at({Quat::Identity(), Vec3(0, -6.8e-3, 0)}), 0.2e-3, 1e-12);
}

TEST(ExactDepth, SeesWhatOfTheSceneIsInTheTool) {
  // A thin pin of the scene in the middle of a face of the tool, where none of its corners is.
  const TriangleMesh plate = box(Vec3(5e-3, 5e-3, 1e-3));
  const TriangleMesh pin = box(Vec3(0.01e-3, 0.01e-3, 2e-3));
  const ExactDepth depth(plate, pin, 10e-3);
  EXPECT_NEAR(depth.at({Quat::Identity(), Vec3(0.1e-3, 0.2e-3, 2.98e-3)}), 20e-6, 1e-12);
}

// Two edges that cross, far from any corner: d deep along the normal of both, d / sqrt(2) from the faces.
TEST(ExactDepth, SeesEdgesThatCross) {
  constexpr double r = 0.2e-3;
  const ExactDepth depth(bar_on_edge(r), bar_on_edge(r), 4e-6);
  const Quat crossed(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
  EXPECT_EQ(depth.at({crossed, Vec3(0, 2 * r + 1e-6, 0)}), 0);
  EXPECT_NEAR(depth.at({crossed, Vec3(0, 2 * r - 30e-6, 0)}), 30e-6 / std::numbers::sqrt2, 2e-6);
}

TEST(ExactDepth, ShellsThatOverlapAreOneSolid) {
  TriangleMesh two = box(Vec3(2e-3, 2e-3, 2e-3));
  append(two, moved(two, Eigen::Isometry3d(Eigen::Translation3d(1e-3, 0, 0))));
  const ExactDepth depth(box(Vec3(0.1e-3, 0.1e-3, 0.1e-3)), two, kSpacing);
  EXPECT_GT(depth.at({Quat::Identity(), Vec3(0.5e-3, 0, 0)}), 0.2e-3) << "it is in both";
}

TEST(ExactDepth, IsTheSameWhereverBothAre) {
  const TriangleMesh a = box(Vec3(1e-3, 2e-3, 3e-3)), b = bar_on_edge(2e-3);
  const Pose X_WT{quaternion_exp(Vec3(0.3, -0.2, 0.5)), Vec3(2.1e-3, 0.4e-3, 0)};
  const double here = ExactDepth(a, b, kSpacing).at(X_WT);
  ASSERT_GT(here, 0.1e-3);
  const Pose X{quaternion_exp(Vec3(-1, 2, 0.3)), Vec3(0.2, -0.1, 0.4)};
  Eigen::Isometry3d all = Eigen::Isometry3d::Identity();
  all.linear() = X.q.toRotationMatrix();
  all.translation() = X.p;
  EXPECT_NEAR(ExactDepth(a, moved(b, all), kSpacing).at(X * X_WT), here, 1e-12);
}

}  // namespace
}  // namespace fulcrum::parts
