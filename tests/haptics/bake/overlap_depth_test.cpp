// The depth of an overlap against formulas, and against a judge that samples both surfaces densely and knows
// the distance to a box from a formula.

#include "haptics/bake/overlap_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "tests/haptics/bake/shapes.h"
#include "tests/haptics/bake/truth.h"

namespace fulcrum::test {
namespace {

Quat rotation_about(const Vec3& axis, double degrees) {
  return Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
}

struct Box {
  Vec3 low, high;
};

TriangleMesh mesh_of(const std::vector<Box>& boxes) {
  TriangleMesh mesh;
  for (const Box& box : boxes) shapes::append(mesh, shapes::box(box.low, box.high));
  return mesh;
}

class OverlapScene {
public:
  OverlapScene(const TriangleMesh& scene_W, const TriangleMesh& tool_T)
      : scene_W_(repaired(scene_W)),
        tool_T_(repaired(tool_T)),
        field_(*bake_field(scene_W_, {.voxel_m = 0.6e-3, .threads = 1})),
        overlap_(scene_W_, tool_T_, &field_),
        without_field_(scene_W_, tool_T_, nullptr) {}
  const OverlapDepth* operator->() const { return &overlap_; }
  const OverlapDepth& without_field() const { return without_field_; }

private:
  Solid scene_W_, tool_T_;
  DistanceField field_;
  OverlapDepth overlap_, without_field_;
};

// At most `step` apart.
std::vector<Vec3> surface_points(const std::vector<Box>& boxes, double step) {
  std::vector<Vec3> points;
  for (const Box& box : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Vec3 size = box.high - box.low;
      const int n = static_cast<int>(std::ceil(size[u] / step)),
                m = static_cast<int>(std::ceil(size[v] / step));
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= m; ++j) {
          Vec3 p = box.low;
          p[u] += size[u] * i / n;
          p[v] += size[v] * j / m;
          points.push_back(p);
          p[axis] = box.high[axis];
          points.push_back(p);
        }
      }
    }
  }
  return points;
}

// How deep the surfaces of `mine` reach into any one of `theirs`, by points `step` apart: short by less than
// that.
double sampled(const std::vector<Box>& mine, const std::vector<Box>& theirs, const Pose& X, double step) {
  double deepest = 0;
  for (const Vec3& p : surface_points(mine, step))
    for (const Box& box : theirs)
      deepest = std::max(deepest, -shapes::box_distance(X * p, box.low, box.high));
  return deepest;
}

const Box kCube{Vec3::Constant(-0.01), Vec3::Constant(0.01)};

// Two roofs, ridge across ridge. No corner of either is inside the other; the deepest points are the ridges',
// where they cross: h below a ridge both of whose slopes are at 45 degrees.
TEST(OverlapDepth, EdgeAgainstEdge) {
  const OverlapScene scene(
      shapes::rotated(shapes::box(kCube.low, kCube.high), rotation_about(Vec3::UnitZ(), 45)),
      shapes::rotated(shapes::box(kCube.low, kCube.high), rotation_about(Vec3::UnitX(), 45)));
  for (const double h : {1e-6, 1e-5, 4.4e-4, 3e-3}) {
    const Pose X_WT{Quat::Identity(), {1e-3, 2 * 0.01 * std::numbers::sqrt2 - h, 2e-3}};
    const DeepestOverlap overlap = scene->at(X_WT, {.tolerance = 1e-9});
    EXPECT_NEAR(overlap.depth, h / std::numbers::sqrt2, 1e-9) << h;
    EXPECT_GE(overlap.bound, overlap.depth);
    EXPECT_LE(overlap.bound, overlap.depth + 1.1e-9);
    EXPECT_LT((overlap.p_W - Vec3(0, 0.01 * std::numbers::sqrt2, 2e-3)).norm(), 1.5 * h + 1e-8);
  }
}

TEST(OverlapDepth, WhatIsApartHasNone) {
  const OverlapScene scene(shapes::box(kCube.low, kCube.high), shapes::box(kCube.low, kCube.high));
  for (const double gap : {1e-9, 1e-5, 1e-2, 1.0}) {
    for (const Vec3& p :
         {Vec3(0.02 + gap, 0, 0), Vec3(0.004, 0.02 + gap, -0.003), Vec3(0.02 + gap, 0.02, 0.02)}) {
      EXPECT_EQ(scene->at({Quat::Identity(), p}, {}).depth, 0.0) << gap;
      EXPECT_LE(scene->at({Quat::Identity(), p}, {}).bound, 1e-6) << gap;
    }
  }
}

TEST(OverlapDepth, FaceOnFaceIsAsDeepAsItIs) {
  const OverlapScene scene(shapes::box(kCube.low, kCube.high), shapes::grid_box(kCube.low, kCube.high, 12));
  for (const double depth : {1e-8, 1e-6, 1e-4}) {
    const Pose X_WT{Quat::Identity(), {0.003, 0.02 - depth, -0.002}};
    EXPECT_NEAR(scene->at(X_WT, {.tolerance = 1e-9}).depth, depth, 1e-9);
    const DeepestOverlap coarse = scene->at(X_WT, {});
    EXPECT_NEAR(coarse.depth, depth, 1e-6);
    EXPECT_LT(coarse.distances, 20000) << depth << ": a flat contact is settled without being cut to pieces";
  }
}

// Its surface crosses nothing; the deepest points of a little cube are its corner's farthest from every face.
TEST(OverlapDepth, WhatLiesInsideWholeIsFound) {
  const OverlapScene scene(shapes::box(kCube.low, kCube.high),
                           shapes::box(Vec3::Constant(-0.001), Vec3::Constant(0.001)));
  const DeepestOverlap overlap = scene->at({Quat::Identity(), {0.004, 0.0, 0.0}}, {.tolerance = 1e-9});
  EXPECT_NEAR(overlap.depth, 0.007, 1e-9);  // on its face at x = 3 mm
  const OverlapScene around(shapes::box(Vec3::Constant(-0.001), Vec3::Constant(0.001)),
                            shapes::box(kCube.low, kCube.high));
  EXPECT_NEAR(around->at({Quat::Identity(), {0.004, 0.0, 0.0}}, {.tolerance = 1e-9}).depth, 0.007, 1e-9);
}

// A bar, tilted, in a slot between two walls, and bars of every kind across each other.
TEST(OverlapDepth, AgreesWithAJudgeThatSamples) {
  const std::vector<Box> walls{{{-0.02, -0.01, -0.011}, {0.02, 0.01, -0.004}},
                               {{-0.02, -0.01, 0.004}, {0.02, 0.01, 0.011}}};
  const std::vector<Box> bar{{{-0.015, -0.003, -0.0038}, {0.015, 0.003, 0.0038}}};
  const OverlapScene scene(mesh_of(walls), mesh_of(bar));
  std::mt19937_64 random(15);
  std::uniform_real_distribution<double> unit(-1, 1);
  int touching = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3 axis = Vec3(unit(random), unit(random), unit(random)).normalized();
    const double degrees = i % 3 == 0 ? 90 * unit(random) : 5 * unit(random);
    const Pose X_WT{rotation_about(axis, degrees),
                    0.004 * Vec3(4 * unit(random), 3 * unit(random), 0.2 * unit(random))};
    const double truth = std::max(sampled(bar, walls, X_WT, 1e-4), sampled(walls, bar, X_WT.inverse(), 1e-4));
    const DeepestOverlap overlap = scene->at(X_WT, {.tolerance = 1e-7});
    EXPECT_GE(overlap.depth, truth - 1e-7) << i;
    EXPECT_LE(overlap.depth, truth + 1e-4) << i;
    EXPECT_LE(overlap.bound, overlap.depth + 1.1e-7) << i;
    EXPECT_NEAR(scene.without_field().at(X_WT, {.tolerance = 1e-7}).depth, overlap.depth, 1.1e-7) << i;
    touching += truth > 0;
  }
  EXPECT_GT(touching, 12);
}

// What is asked for less is answered for less, and no answer promises what is not so.
TEST(OverlapDepth, BoundsHoldWhateverTheLimits) {
  const std::vector<Box> bar{{{-0.015, -0.003, -0.003}, {0.015, 0.003, 0.003}}};
  const OverlapScene scene(mesh_of(bar), mesh_of(bar));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = Vec3(unit(random), unit(random), unit(random)).normalized();
    const Pose X_WT{rotation_about(axis, 180 * unit(random)),
                    0.006 * Vec3(unit(random), unit(random), unit(random))};
    const double depth = scene->at(X_WT, {.tolerance = 1e-8}).depth;
    const DeepestOverlap short_of_work = scene->at(X_WT, {.tolerance = 1e-8, .distances = 40});
    EXPECT_LE(short_of_work.depth, depth + 1e-12);
    EXPECT_GE(short_of_work.bound, depth - 1e-8) << i;
    const DeepestOverlap above = scene->at(X_WT, {.above = 1.5e-3, .tolerance = 1e-8});
    EXPECT_GE(above.bound, depth - 1e-8);
    if (depth > 1.5e-3 + 1e-8)
      EXPECT_NEAR(above.depth, depth, 2e-8);
    else if (depth < 1.5e-3)
      EXPECT_EQ(above.depth, 0.0);
  }
}

// How near the surfaces of `mine` come to any one of `theirs`, by points: no less than they do.
double nearest_sampled(const std::vector<Box>& mine, const std::vector<Box>& theirs, const Pose& X,
                       double step) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : surface_points(mine, step))
    for (const Box& box : theirs) nearest = std::min(nearest, shapes::box_distance(X * p, box.low, box.high));
  return nearest;
}

// Never more than it is, and not much less: a run is judged by few poses where it says how far the tool is.
TEST(OverlapDepth, TheClearanceIsNoMoreThanItIs) {
  const std::vector<Box> bar{{{-0.015, -0.003, -0.003}, {0.015, 0.003, 0.003}}};
  const OverlapScene scene(mesh_of(bar), mesh_of(bar));
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int clear = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 axis = Vec3(unit(random), unit(random), unit(random)).normalized();
    const double far = i % 2 == 0 ? 0.02 : 0.2;
    const Pose X_WT{rotation_about(axis, 180 * unit(random)),
                    far * Vec3(unit(random), unit(random), unit(random))};
    const double truth =
        std::min(nearest_sampled(bar, bar, X_WT, 5e-4), nearest_sampled(bar, bar, X_WT.inverse(), 5e-4));
    for (const OverlapDepth* each : {scene.operator->(), &scene.without_field()}) {
      const DeepestOverlap overlap = each->at(X_WT, {});
      if (overlap.depth > 0) {
        EXPECT_EQ(overlap.clearance, 0.0) << i;
        continue;
      }
      EXPECT_LE(overlap.clearance, truth) << i;
      if (truth < 1e-3) continue;
      EXPECT_GE(overlap.clearance, 0.4 * truth) << i;
      ++clear;
    }
  }
  EXPECT_GT(clear, 200);
}

}  // namespace
}  // namespace fulcrum::test
