#include "haptics/geometry/pointshell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "haptics/geometry/sphere_tree.h"

namespace fulcrum {
namespace {

TEST(Pointshell, ExplicitPointsAreKept) {
  const std::vector<Vec3> corners{{-0.01, 0, 0}, {0.01, 0, 0}, {0.01, 0.03, 0}, {-0.01, 0.03, 0}};
  const std::vector<Vec3> normals(4, Vec3(0, -2, 0));
  const std::vector<double> areas{1, 2, 3, 4};
  const auto shell = pointshell_from_points(corners, normals, areas, 0.005);
  ASSERT_TRUE(shell);
  ASSERT_EQ(shell->size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(shell->positions[i], corners[i]);
    EXPECT_EQ(shell->normals[i], Vec3(0, -1, 0));
    EXPECT_EQ(shell->areas_m2[i], areas[i]);
  }
  EXPECT_EQ(shell->covering_radius_m, 0.005);
  EXPECT_NEAR(shell->max_radius_m, std::hypot(0.01, 0.03), 1e-15);
}

TEST(Pointshell, EveryRunOfSixteenIsCompact) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  std::vector<Vec3> points;
  for (int i = 0; i < 16 * 1024; ++i) points.emplace_back(coordinate(random), coordinate(random), 0.0);
  const std::vector<Vec3> normals(points.size(), Vec3::UnitZ());
  const std::vector<double> areas(points.size(), 1.0);
  const auto shell = pointshell_from_points(points, normals, areas, 0.0);
  ASSERT_TRUE(shell);
  double sum = 0.0;
  for (std::size_t i = 0; i < shell->size(); i += 16) {
    Eigen::AlignedBox3d box;
    for (std::size_t j = i; j < i + 16; ++j) box.extend(shell->positions[j]);
    sum += box.diagonal().norm();
  }
  EXPECT_LT(sum / 1024.0, 2.0 / 32.0);  // 1024 cells of a unit square are 1/32 wide
}

TEST(Pointshell, BadPointsAreRefusedWithASentence) {
  const std::vector<Vec3> one{Vec3::Zero()}, up{Vec3::UnitY()}, zero{Vec3::Zero()};
  const std::vector<Vec3> bad{Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0)};
  const std::vector<double> area{1.0}, negative{-1.0};
  EXPECT_FALSE(pointshell_from_points({}, {}, {}, 0.0));
  EXPECT_FALSE(pointshell_from_points(one, {}, area, 0.0));
  EXPECT_FALSE(pointshell_from_points(one, zero, area, 0.0));
  EXPECT_FALSE(pointshell_from_points(bad, up, area, 0.0));
  EXPECT_FALSE(pointshell_from_points(one, up, negative, 0.0));
  EXPECT_FALSE(pointshell_from_points(one, up, area, -1.0));
}

TEST(Pointshell, TransformMovesPointsAndTurnsNormals) {
  const std::vector<Vec3> points{{1, 0, 0}}, normals{{1, 0, 0}};
  const std::vector<double> areas{1.0};
  const auto shell = pointshell_from_points(points, normals, areas, 0.0);
  ASSERT_TRUE(shell);
  const Pose X_TM{Quat(Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitZ())), Vec3(0, 2, 0)};
  const Pointshell moved = transformed(*shell, X_TM);
  EXPECT_NEAR((moved.positions[0] - Vec3(0, 3, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((moved.normals[0] - Vec3(0, 1, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(moved.max_radius_m, 3.0, 1e-15);
}

TEST(Pointshell, EveryNodeOfTheSphereTreeHoldsItsPointsTightly) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-0.1, 0.1);
  std::vector<Vec3> points;
  for (int i = 0; i < 5003; ++i) points.emplace_back(coordinate(random), coordinate(random), 0.0);
  const auto shell = pointshell_from_points(points, std::vector<Vec3>(points.size(), Vec3::UnitZ()),
                                            std::vector<double>(points.size(), 1.0), 0.0);
  ASSERT_TRUE(shell);
  const SphereTree tree = build_sphere_tree(*shell);
  ASSERT_EQ(tree.patches.size(), 313u);
  ASSERT_EQ(tree.levels.size(), 3u);
  ASSERT_EQ(tree.levels.back().size(), 1u);
  std::size_t run = 1;
  for (const auto& level : tree.levels) {
    run *= kBlock;
    double radii = 0, nodes = 0;
    for (std::size_t i = 0; i * run < shell->size(); ++i) {
      const SphereTree::Spheres& block = level[i / kBlock];
      const std::size_t lane = i % kBlock;
      const Vec3 centre(static_cast<double>(block.x[lane]), static_cast<double>(block.y[lane]),
                        static_cast<double>(block.z[lane]));
      for (std::size_t j = i * run; j < std::min((i + 1) * run, shell->size()); ++j)
        ASSERT_LE((shell->positions[j] - centre).norm(), static_cast<double>(block.radius[lane]));
      radii += static_cast<double>(block.radius[lane]);
      nodes += 1;
    }
    EXPECT_LT(radii / nodes, 0.2 * std::sqrt(static_cast<double>(run) / 5003)) << run;  // cells of a square
    EXPECT_TRUE(std::isnan(level.back().x.back()));
  }
}

}  // namespace
}  // namespace fulcrum
