// What is gathered along a way, against looks at single poses on it and around it.

#include "haptics/contact/feature_gathering.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <set>
#include <utility>

#include "haptics/contact/feature_pairs.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {
namespace {

using Named = std::set<std::pair<std::uint32_t, std::uint32_t>>;

class FeatureGatheringTest : public testing::Test {
protected:
  static std::shared_ptr<const FeatureMesh> features(const TriangleMesh& mesh) {
    const Solid solid = shapes::solid_of(mesh);
    return std::make_shared<const FeatureMesh>(solid.mesh, solid.neighbours);
  }
  Named named(FeatureGathering::Kind kind) {
    Named all;
    for (const FeatureCandidate& candidate : gathering.candidates(kind))
      all.emplace(candidate.tool, candidate.scene);
    return all;
  }
  double any(double most) { return std::uniform_real_distribution<double>(-most, most)(random); }
  Vec3 in_cube(double half) { return {any(half), any(half), any(half)}; }
  ToolWay any_way() {
    ToolWay way{.X_WT = {quaternion_exp(in_cube(3)), Vec3(0.009, 0.006, 0) + in_cube(0.004)}};
    way.step << in_cube(0.001), in_cube(0.1);
    way.reach = 9e-4;
    way.turn = 0.02;
    return way;
  }

  std::mt19937_64 random{5};
  const std::shared_ptr<const FeatureMesh> tool =
      features(shapes::box(Vec3(-0.003, -0.001, -0.007), Vec3(0.002, 0.001, 0.006)));
  const std::shared_ptr<const FeatureMesh> scene = features(shapes::torus(0.01, 0.004, 24, 16));
  FeatureGathering gathering{*tool, *scene, FeaturePairs::kMostTurn, FeaturePairs::kDeepest};
};

TEST_F(FeatureGatheringTest, HasWhateverALookOnTheWayFinds) {
  constexpr double kNear = 7e-4;  // m
  std::size_t seen = 0;
  FeaturePairs pairs(tool, scene);
  for (int trial = 0; trial < 1000; ++trial) {
    const ToolWay way = any_way();
    gathering.begin(way, FeatureGathering::kMostCandidates);
    gathering.go_on();
    ASSERT_TRUE(gathering.is_done());
    const Named edges = named(FeatureGathering::kEdgeEdge), faces = named(FeatureGathering::kFaceVertex),
                vertices = named(FeatureGathering::kVertexFace);
    for (int at = 0; at < 5; ++at) {
      Pose X_WT = way.at(std::uniform_real_distribution<double>(0, 1)(random));
      X_WT.q = (quaternion_exp(in_cube(0.011)) * X_WT.q).normalized();
      X_WT.p += in_cube(1e-4);
      const ToolWay::Place place = way.place(X_WT, tool->radius());
      if (kNear + place.off > way.reach || place.turn_off > way.turn) continue;
      ASSERT_TRUE(pairs.look(X_WT, kNear));
      for (const FeaturePair& pair : pairs.pairs()) {
        const auto kind = pair.key >> 60;
        const auto of_tool = static_cast<std::uint32_t>(pair.key >> 30 & ((1u << 30) - 1)),
                   of_scene = static_cast<std::uint32_t>(pair.key & ((1u << 30) - 1));
        ++seen;
        if (kind == 0)
          EXPECT_TRUE(vertices.contains({of_tool, of_scene})) << trial;
        else if (kind == 3)
          EXPECT_TRUE(faces.contains({of_tool, of_scene})) << trial;
        else if (kind == 5)
          EXPECT_TRUE(edges.contains({of_tool, of_scene})) << trial;
      }
    }
  }
  EXPECT_GT(seen, 400u);
}

TEST_F(FeatureGatheringTest, InPartsIsTheSameAsAtOnce) {
  for (int trial = 0; trial < 100; ++trial) {
    const ToolWay way = any_way();
    gathering.begin(way, FeatureGathering::kMostCandidates);
    gathering.go_on();
    const Named edges = named(FeatureGathering::kEdgeEdge), faces = named(FeatureGathering::kFaceVertex);
    const std::size_t visits = gathering.visits();
    gathering.begin(way, FeatureGathering::kMostCandidates);
    int parts = 0;
    for (; !gathering.is_done(); ++parts) gathering.go_on(7);
    EXPECT_EQ(gathering.visits(), visits);
    // The last part may find that nothing was left.
    EXPECT_LE(visits / 7, static_cast<std::size_t>(parts));
    EXPECT_LE(static_cast<std::size_t>(parts), visits / 7 + 1);
    EXPECT_EQ(named(FeatureGathering::kEdgeEdge), edges);
    EXPECT_EQ(named(FeatureGathering::kFaceVertex), faces);
  }
}

TEST_F(FeatureGatheringTest, GivesUpWhereThereIsTooMuch) {
  ToolWay way = any_way();
  way.X_WT = {Quat::Identity(), Vec3(0.01, 0.0035, 0)};
  gathering.begin(way, FeatureGathering::kMostCandidates);
  gathering.go_on();
  ASSERT_TRUE(gathering.is_done());
  const std::size_t most =
      std::max(named(FeatureGathering::kEdgeEdge).size(), named(FeatureGathering::kFaceVertex).size());
  ASSERT_GT(most, 1u);
  gathering.begin(way, most - 1);
  gathering.go_on();
  EXPECT_FALSE(gathering.is_begun());
  EXPECT_FALSE(gathering.is_done());
}

TEST_F(FeatureGatheringTest, APlaceOnTheWayIsFoundAndHowFarOffItIs) {
  const ToolWay way = any_way();
  const Pose third = way.at(1.0 / 3);
  const ToolWay::Place on = way.place(third, tool->radius());
  EXPECT_NEAR(on.part, 1.0 / 3, 1e-12);
  EXPECT_LT(on.off, 1e-8);
  EXPECT_LT(on.turn_off, 1e-7);
  const Vec3 beside = way.step.head<3>().cross(Vec3::UnitX()).normalized();
  const ToolWay::Place off = way.place({third.q, third.p + 1e-4 * beside}, tool->radius());
  EXPECT_NEAR(off.off, 1e-4, 1e-8);
  const Pose before{way.X_WT.q, way.X_WT.p - way.step.head<3>()};
  EXPECT_EQ(way.place(before, tool->radius()).part, 0);
}

}  // namespace
}  // namespace fulcrum
