#include "engine/analysis/workprecision/workprecision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/analysis/shapes.h"
#include "engine/analysis/workprecision/report.h"

namespace fulcrum::analysis::workprecision {
namespace {

struct Convergent {
  const char* name;
  WorkStudy (*study)(bool quick);
};

class Orders : public testing::TestWithParam<Convergent> {};

TEST_P(Orders, AreWithinATenthOfTheory) {
  const WorkStudy study = GetParam().study(true);
  int checked = 0;
  for (const auto& [method, expected] : study.expected_order) {
    for (const WorkPoint& point : study.points) {
      if (point.method != method || point.order == 0) continue;
      EXPECT_NEAR(point.order, expected, 0.1) << study.truth << ", " << method << " at " << point.value;
      ++checked;
    }
  }
  EXPECT_GE(checked, static_cast<int>(study.expected_order.size()));
}

INSTANTIATE_TEST_SUITE_P(Each, Orders,
                         testing::Values(Convergent{"Field", study_field}, Convergent{"Tick", study_tick},
                                         Convergent{"Oscillator", study_oscillator},
                                         Convergent{"Tumbling", study_tumbling},
                                         Convergent{"Tone", study_tone}),
                         [](const auto& convergent) -> std::string { return convergent.param.name; });

TEST(WorkPrecision, AHeldToneKeepsItsAmplitude) {
  for (const WorkPoint& point : study_tone(true).points)
    if (point.method == "held")
      EXPECT_LT(point.error, 1e-9) << point.value;
    else
      EXPECT_GT(point.error, 1e-3) << point.value;
}

// At the same voxel, where both look up the same points: what that costs is for the report, no test.
TEST(WorkPrecision, TheFieldBeatsTheClassicMethodTwentyfold) {
  const WorkStudy study = study_tube(true);
  for (const WorkPoint& field : study.points) {
    for (const WorkPoint& classic : study.points) {
      if (field.method != "distance field" || classic.method != "classic voxels") continue;
      if (field.value != classic.value) continue;
      EXPECT_GT(classic.error, 20 * field.error) << field.value;
    }
  }
}

// What is felt does not depend on how many points sample it.
TEST(WorkPrecision, SamplingIsNotFelt) {
  for (const WorkPoint& point : study_sampling(true).points) {
    if (point.method != "distance field") continue;
    EXPECT_LT(point.error, 0.05) << point.value;
  }
}

// Between a tool's points nothing goes in, once the scene's edges are asked as well.
TEST(WorkPrecision, AKnifeEdgeIsFeltWhereItIs) {
  const WorkStudy study = study_rest(true);
  for (const WorkPoint& edges : study.points) {
    if (edges.method != "edges") continue;
    EXPECT_LT(edges.error, 0.05) << edges.value;  // of a millimetre; the roller's field has 0.5 mm voxels
    for (const WorkPoint& even : study.points) {
      if (even.method != "even" || even.value != edges.value) continue;
      EXPECT_GT(even.error, 10 * edges.error) << edges.value;
    }
  }
  // On triangles by what its facets lie off the roller's circle, l^2 / (16 R), and by how far they lean.
  int faceted = 0;
  for (const WorkPoint& point : study.points) {
    if (point.method != "triangles") continue;
    EXPECT_LT(point.error, 1.5 * point.value * point.value / (16 * 4) + 5e-4) << point.value;
    ++faceted;
  }
  EXPECT_EQ(faceted, 2);
}

// At the same voxel; what that costs is for the report, no test.
void expect_truer_than_voxels(const WorkStudy& study, double times) {
  int compared = 0;
  for (const WorkPoint& ours : study.points) {
    for (const WorkPoint& classic : study.points) {
      if (ours.method == "voxel" || classic.method != "voxel" || ours.value != classic.value) continue;
      EXPECT_GT(classic.error, times * ours.error)
          << study.truth << ", " << ours.method << " at " << ours.value;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6) << study.truth;
}

TEST(WorkPrecision, PressesAreFeltTruerThanByClassicVoxels) {
  expect_truer_than_voxels(study_press_groove(true), 20);
  expect_truer_than_voxels(study_press_table(true), 20);
  // The classic method takes its normals from the ball, where they are exact.
  expect_truer_than_voxels(study_press_tube(true), 5);
}

TEST(WorkPrecision, PegsJamWhereTheyShould) {
  const std::vector<WorkStudy> studies = study_pegs(true);
  ASSERT_EQ(studies.size(), 3u);
  for (const WorkStudy& study : studies) {
    expect_truer_than_voxels(study, 2);
    const auto of = [&](const char* method) {
      return *std::ranges::find(study.points, std::string_view(method), &WorkPoint::method);
    };
    EXPECT_LT(of("triangles").error, of("constraint").error) << study.truth;
  }
}

// The observer reads below the truth at every count size; booking whole counts reads above it, and what it is
// off by grows with the count.
TEST(WorkPrecision, ThePortErrsToTheSafeSideAndFinerCountsBringItNearer) {
  const WorkStudy study = study_port(true);
  ASSERT_EQ(study.points.size(), 8u);
  for (std::size_t i = 0; i + 1 < study.points.size(); i += 2) {
    EXPECT_EQ(study.points[i].method, study.points[i + 1].method);
    EXPECT_GT(study.points[i].value, study.points[i + 1].value);
    EXPECT_LT(study.points[i + 1].error, study.points[i].error) << study.points[i].method;
  }
}

// A rod across a tube, in place of the shipped scene: what refines towards itself.
TEST(WorkPrecision, PipingComesNearerToItsFinest) {
  PipingParts parts;
  parts.scene_W = tube_mesh(8e-3, 12e-3, 40e-3, 64);
  parts.tool_T = box_mesh({-4e-3, -4e-3, -10e-3}, {4e-3, 4e-3, 10e-3});
  parts.X_WT.p.x() = 3e-3;
  const std::vector<WorkStudy> studies = study_piping(parts, true);
  ASSERT_EQ(studies.size(), 2u);
  for (const WorkStudy& study : studies) {
    ASSERT_EQ(study.points.size(), 4u);
    EXPECT_LT(study.points[1].error, study.points[0].error) << study.truth;
    EXPECT_GT(study.points[0].error, 0) << study.truth;
    EXPECT_LT(study.points[1].error, study.points[3].error) << study.truth << ", against classic voxels";
  }
}

TEST(WorkPrecision, AdvantageComparesAtTheSameCost) {
  WorkStudy study;
  study.truth = "tube";
  study.baseline = "voxel";
  study.points = {{"penalty", 1, 0.01, 10, 0},  {"penalty", 2, 0.001, 30, 0}, {"static", 1, 0.01, 50, 0},
                  {"voxel", 1, 0.5, 5, 0},      {"voxel", 2, 0.3, 20, 0},     {"voxel", 3, 0.15, 40, 0},
                  {"constraint", 1, 0.01, 1, 0}};
  EXPECT_DOUBLE_EQ(advantage(study, "penalty"), 30);     // .3 / .01 at 20 us; .15 / .001 at 40 us
  EXPECT_DOUBLE_EQ(advantage(study, "constraint"), 15);  // .15 / .01
  EXPECT_EQ(advantage(study, "static"), 0);              // dearer than the dearest
  const report::Table table = advantage_table({study});
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].back(), "met");
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"tube", "static", "voxel", "dearer", "missed"}));
  EXPECT_EQ(table.rows[2].back(), "missed");
  EXPECT_NE(goal_sentence({study}).find("met by 1 of 3"), std::string::npos);
}

TEST(WorkPrecision, CsvHasTheColumnsThatScriptsRelyOn) {
  WorkStudy study;
  study.truth = "tube";
  study.parameter = "voxel (mm)";
  study.points = {{"distance field", 1, 0.25, 10, 2}};
  EXPECT_EQ(work_csv({study}).text(),
            "truth,method,parameter,value,error,error_unit,cpu_us,order\n"
            "tube,distance field,voxel (mm),1,0.25,,10,2\n");
}

}  // namespace
}  // namespace fulcrum::analysis::workprecision
