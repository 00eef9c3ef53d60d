// Every SIMD target against the same sums written out, bit for bit.

#include "haptics/contact/shell_walk.h"
#include "haptics/contact/field_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "haptics/contact/query.h"
#include "hwy/targets.h"
#include "tests/haptics/bake/shapes.h"
#include "tests/haptics/contact/walk_reference.h"
#include "tests/haptics/scenes.h"

namespace fulcrum {
namespace {

// Restores the processor's own choice.
class Targets : public testing::Test {
protected:
  void TearDown() override {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  static std::vector<std::int64_t> all() {
    hwy::SetSupportedTargetsForTest(0);
    std::vector<std::int64_t> targets;
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
      targets.push_back(left & -left);
    return targets;
  }
  // Whether the program holds code for it: else the name would be that of another.
  static bool take(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    return std::string_view(simd_target()) == hwy::TargetName(target);
  }
};

DistanceField torus_field(FieldFormat format) {
  TriangleMesh mesh = shapes::torus(0.03, 0.01, 48, 24);
  shapes::append(mesh, shapes::box(Vec3(-0.05, -0.02, -0.02), Vec3(0.05, 0.024, 0.024)));
  const Solid solid = test::expect(build_solid(mesh));
  return test::expect(bake_field(solid, {.voxel_m = 1e-3, .band_m = 2e-3, .format = format, .threads = 1}));
}

std::vector<Vec3> random_points(std::size_t n) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-0.03, 0.03);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

ShellWalk walk_of(const SphereTree& tree, const DistanceField& field, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Mat3 turn =
      Quat(normal(random), normal(random), normal(random), normal(random)).normalized().toRotationMatrix() /
      field.voxel_m();
  const Vec3 shift =
      (0.03 * Vec3(normal(random), normal(random), normal(random)) - field.data().origin) / field.voxel_m();
  ShellWalk walk{};
  walk.tree = &tree;
  walk.field = view_of(field);
  for (int i = 0; i < 9; ++i) walk.turn[static_cast<std::size_t>(i)] = turn(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) walk.shift[static_cast<std::size_t>(i)] = shift[i];
  walk.slack = static_cast<float>(3 * field.error_bound_m());
  walk.brick_slack = field.data().centre_m.data();  // never taken: no node is small enough
  walk.brick_edge = 0;
  return walk;
}

// By point; what was not found stays as it is.
std::vector<test::Looked> walked(ShellWalk walk) {
  struct Found {
    std::vector<test::Looked> points;
    std::uint32_t next = 0;
    bool in_order = true;
    float margin = 0;
  } found;
  found.margin = walk.margin;
  found.points.resize(walk.tree->patches.size() * kBlock);
  walk.taker = &found;
  walk.found = [](void* to, const PatchHit& hit) noexcept {
    Found& into = *static_cast<Found*>(to);
    into.in_order = into.in_order && hit.first >= into.next;
    into.next = hit.first + 1;
    for (std::uint32_t lane = 0; lane < kBlock; ++lane) {
      if ((hit.touching >> lane & 1u) == 0) continue;
      test::Looked& point = into.points[hit.first + lane];
      point.distance = hit.distance[lane];
      point.touching = true;
    }
    return into.margin;
  };
  walk_shell(walk);
  EXPECT_TRUE(found.in_order);
  return found.points;
}

std::vector<test::Looked> expected(const ShellWalk& walk) {
  std::vector<test::Looked> points;
  for (std::size_t patch = 0; patch < walk.tree->patches.size(); ++patch) {
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      const test::Looked point = test::look_up(walk, patch, lane);
      points.push_back(point.touching ? point : test::Looked{});
    }
  }
  return points;
}

TEST_F(Targets, GiveTheBitsOfTheSumsWrittenOut) {
  const auto shell = test::shell_of(random_points(5000));
  const SphereTree tree = build_sphere_tree(*shell);
  for (const FieldFormat format : {FieldFormat::int16, FieldFormat::float32}) {
    const DistanceField field = torus_field(format);
    int tried = 0;
    for (const std::int64_t target : all()) {
      if (!take(target)) continue;
      ++tried;
      std::mt19937_64 random(5);
      std::size_t touching = 0;
      for (int pose = 0; pose < 60; ++pose) {
        ShellWalk walk = walk_of(tree, field, random);
        walk.margin = pose % 3 == 0 ? 1e-3f : 0.0f;
        const std::vector<test::Looked> want = expected(walk);
        ASSERT_TRUE(walked(walk) == want) << hwy::TargetName(target) << ", pose " << pose;
        for (const test::Looked& point : want) touching += point.touching ? 1 : 0;
      }
      EXPECT_GT(touching, 1000u);
    }
    EXPECT_GE(tried, 2) << "nothing was compared: this processor has one target alone";
  }
}

TEST_F(Targets, GiveTheNormalsWrittenOut) {
  for (const FieldFormat format : {FieldFormat::int16, FieldFormat::float32}) {
    const DistanceField field = torus_field(format);
    const FieldView view = view_of(field);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const std::int64_t target : all()) {
      if (!take(target)) continue;
      std::mt19937_64 random(8);
      std::size_t known = 0, unknown = 0;
      for (int i = 0; i < 200; ++i) {
        NormalBatch batch{};
        for (std::size_t lane = 0; lane < kBlock; ++lane) {
          const auto place = [&](std::size_t axis) {
            return std::uniform_real_distribution<float>(-2, view.cells[axis] + 2)(random);
          };
          batch.x[lane] = i % 50 == 49 ? nan : place(0);
          batch.y[lane] = place(1);
          batch.z[lane] = place(2);
        }
        look_up_normals(view, Normals::across_cells, batch);
        for (std::size_t lane = 0; lane < kBlock; ++lane) {
          const test::Normal want =
              test::normal_across_cells(view, {batch.x[lane], batch.y[lane], batch.z[lane]});
          ASSERT_EQ((batch.known >> lane & 1u) != 0, want.known) << hwy::TargetName(target);
          (want.known ? known : unknown) += 1;
          if (!want.known) continue;
          ASSERT_EQ((std::array{batch.nx[lane], batch.ny[lane], batch.nz[lane]}), want.n)
              << hwy::TargetName(target);
        }
      }
      EXPECT_GT(known, 200u);
      EXPECT_GT(unknown, 200u);
    }
  }
}

TEST_F(Targets, GiveTheSameGradientsWithinACell) {
  for (const FieldFormat format : {FieldFormat::int16, FieldFormat::float32}) {
    const DistanceField field = torus_field(format);
    const FieldView view = view_of(field);
    std::mt19937_64 random(9);
    for (int i = 0; i < 200; ++i) {
      NormalBatch asked{};
      for (std::size_t lane = 0; lane < kBlock; ++lane) {
        asked.x[lane] = std::uniform_real_distribution<float>(0, view.cells[0])(random);
        asked.y[lane] = std::uniform_real_distribution<float>(0, view.cells[1])(random);
        asked.z[lane] = std::uniform_real_distribution<float>(0, view.cells[2])(random);
      }
      std::vector<NormalBatch> answers;
      for (const std::int64_t target : all()) {
        if (!take(target)) continue;
        answers.push_back(asked);
        look_up_normals(view, Normals::of_cell, answers.back());
      }
      for (std::size_t lane = 0; lane < kBlock; ++lane) {
        const Vec3 p = field.data().origin + field.voxel_m() * Vec3(static_cast<double>(asked.x[lane]),
                                                                    static_cast<double>(asked.y[lane]),
                                                                    static_cast<double>(asked.z[lane]));
        for (const NormalBatch& answer : answers) {
          ASSERT_EQ(answer.known, answers[0].known);
          if ((answer.known >> lane & 1u) == 0) continue;
          const std::array n{answer.nx[lane], answer.ny[lane], answer.nz[lane]};
          ASSERT_EQ(n, (std::array{answers[0].nx[lane], answers[0].ny[lane], answers[0].nz[lane]}));
          const Vec3 nhat(static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2]));
          ASSERT_GT(nhat.dot(field.sample(p).gradient), 0.999) << p.transpose();
        }
      }
    }
  }
}

// Numbers no tool has: the walk reads nothing out of bounds and finds nothing it should not.
TEST_F(Targets, AreSafeWithWhatIsNotANumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  const float tiny = std::numeric_limits<float>::denorm_min();
  const DistanceField field = torus_field(FieldFormat::int16);
  SphereTree tree = build_sphere_tree(*test::shell_of(random_points(48)));
  const std::vector<float> odd{nan, infinity, -infinity, 1e38f, -1e38f, 1e9f, tiny, -tiny, 0.0f, -0.0f};
  for (std::size_t i = 0; i < 48; ++i) {
    SphereTree::Points& patch = tree.patches[i / kBlock];
    patch.x[i % kBlock] = odd[i % odd.size()];
    if (i % 2 == 1) patch.y[i % kBlock] = odd[(i / 2) % odd.size()];
    if (i % 3 == 1) patch.z[i % kBlock] = odd[(i / 3) % odd.size()];
  }
  SphereTree::Spheres& spheres = tree.levels.at(0).at(0);
  spheres.radius = {infinity, infinity, infinity};  // all are looked at
  std::mt19937_64 random(6);
  for (const std::int64_t target : all()) {
    if (!take(target)) continue;
    for (int pose = 0; pose < 20; ++pose) {
      ShellWalk walk = walk_of(tree, field, random);
      walk.margin = 0.02f;
      spheres.x[0] = spheres.x[1] = spheres.x[2] = 0.0f;
      if (pose % 4 == 1) walk.shift[1] = static_cast<double>(odd[static_cast<std::size_t>(pose) / 4]);
      if (pose % 4 == 2) walk.turn[4] = static_cast<double>(odd[static_cast<std::size_t>(pose) / 4]);
      for (std::size_t i = 0; i < tree.patches.size() * kBlock; ++i)
        ASSERT_FALSE(std::isnan(test::look_up(walk, i / kBlock, i % kBlock).distance));
      if (pose % 4 == 0 || pose % 4 == 3)
        ASSERT_TRUE(walked(walk) == expected(walk)) << hwy::TargetName(target) << ", pose " << pose;
      else
        walked(walk);
    }
  }
}

TEST(ContactQuery, APoseThatIsNotANumberTouchesNothing) {
  ContactQuery query(test::shell_of(random_points(500)), test::floor_field());
  ContactSet set;
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    Pose X_WT;
    X_WT.p = Vec3(0, bad, 0);
    query.run(X_WT, set);
    EXPECT_TRUE(set.contacts().empty()) << bad;
    X_WT = {};
    X_WT.q.x() = bad;
    query.run(X_WT, set);
    EXPECT_TRUE(set.contacts().empty()) << bad;
  }
  query.run({Quat::Identity(), Vec3(0, 0, 0)}, set);
  EXPECT_FALSE(set.contacts().empty());
}

}  // namespace
}  // namespace fulcrum
