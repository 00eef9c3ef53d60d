// Where pictures lie on parts: nowhere torn, as dense as they should be, and without a step where they meet.

#include "tools/content/mesh/unwrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/shading.h"
#include "tools/content/mesh/tileable.h"
#include "tools/content/mesh/tube.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double radius = 10.0 * mm;
constexpr int columns = 24;

Solid bent_pipe() {
  const std::vector<Vector3d> corners{{0.0, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.2, 0.2, 0.0}};
  return tube(stations({corners, 3.0 * radius}), radius, columns, TubeEnd::flat, TubeEnd::flat);
}

// How many pictures there are in a metre along a triangle's edges, at the least and at the most.
struct Density {
  double least = 1e9, most = 0.0;
};

Density density(const Solid& solid, const CornerUv& uv, std::size_t triangle) {
  Density found;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length =
        (solid.points[solid.triangles[triangle][k]] - solid.points[solid.triangles[triangle][(k + 1) % 3]])
            .norm();
    const double pictures = (uv[triangle][k] - uv[triangle][(k + 1) % 3]).norm();
    found.least = std::min(found.least, pictures / length);
    found.most = std::max(found.most, pictures / length);
  }
  return found;
}

TEST(Unwrap, APictureLiesEvenlyOnAPipe) {
  const Solid pipe = bent_pipe();
  const double height = 2.0 * pi * radius;
  const CornerUv uv = unwrapped_sections(pipe, columns, {1, height, 0.0});
  ASSERT_EQ(uv.size(), pipe.triangles.size());
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const bool is_end = std::ranges::max(pipe.triangles[i]) >= pipe.points.size() - 2;
    if (is_end) continue;  // round a point
    const Density found = density(pipe, uv, i);
    // A bend's inside is two thirds as long as its middle, its outside four thirds.
    EXPECT_GT(found.least * height, 0.7);
    EXPECT_LT(found.most * height, 1.6);
  }
}

TEST(Unwrap, NoTriangleCrossesTheSeam) {
  const Solid pipe = bent_pipe();
  for (const CornerUv& uv :
       {unwrapped_sections(pipe, columns, {3, 0.1, 0.0}), unwrapped_round(pipe, {3, 0.1, 0.0})})
    for (const auto& corners : uv)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LE(std::abs(corners[k].x() - corners[(k + 1) % 3].x()), 1.5 + 1e-9);
}

TEST(Unwrap, ABoxIsSeenFromItsSides) {
  const Solid box = chamfered_box({0.05, 0.02, 0.01}, 1.0 * mm);
  const CornerUv uv = unwrapped_box(box, 0.1);
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const Density found = density(box, uv, i);
    EXPECT_LT(found.most, 10.0 + 1e-9);
    EXPECT_GT(found.least, 5.7);  // a chamfer of three faces is seen from one of them
  }
}

// What is felt is made of the same points, in the same order.
TEST(Unwrap, SeamsRepeatPointsAfterAllOthers) {
  const Solid pipe = bent_pipe();
  const ShadedMesh before = shade(pipe, 0.7, {});
  ShadedMesh mesh = before;
  const CornerUv corners = unwrapped_sections(pipe, columns, {1, 0.1, 0.0});
  const std::vector<Eigen::Vector2f> uv = split_at_seams(&mesh, corners);
  ASSERT_EQ(uv.size(), mesh.positions.size());
  EXPECT_GT(mesh.positions.size(), before.positions.size());
  // Along the seam, and the two middles of the ends, where a picture comes from all round.
  EXPECT_LT(mesh.positions.size(), before.positions.size() + 3 * columns);
  for (std::size_t i = 0; i < before.positions.size(); ++i) EXPECT_EQ(mesh.positions[i], before.positions[i]);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    EXPECT_EQ(mesh.positions[mesh.indices[i]], before.positions[before.indices[i]]);
    EXPECT_EQ(mesh.normals[mesh.indices[i]], before.normals[before.indices[i]]);
    EXPECT_LT((uv[mesh.indices[i]].cast<double>() - corners[i / 3][i % 3]).norm(), 2e-5);
  }
}

TEST(Tileable, GoesOnWhereItEnds) {
  double least = 1.0, most = 0.0, sum = 0.0;
  constexpr int steps = 200;
  for (int i = 0; i < steps; ++i) {
    const double at = (i + 0.5) / steps;
    EXPECT_NEAR(tileable_noise({0.0, at}, 7, 5, 1), tileable_noise({1.0 - 1e-12, at}, 7, 5, 1), 1e-9);
    EXPECT_NEAR(tileable_noise({at, 0.0}, 7, 5, 1), tileable_noise({at, 1.0 - 1e-12}, 7, 5, 1), 1e-9);
    for (int k = 0; k < steps; ++k) {
      const double value = tileable_noise({at, (k + 0.5) / steps}, 37, 41, 1);
      least = std::min(least, value), most = std::max(most, value), sum += value;
    }
  }
  EXPECT_GE(least, 0.0);
  EXPECT_LE(most, 1.0);
  EXPECT_GT(most - least, 0.8);
  EXPECT_NEAR(sum / (steps * steps), 0.5, 0.03);
}

}  // namespace
}  // namespace fulcrum::content
