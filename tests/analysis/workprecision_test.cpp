#include "engine/analysis/workprecision.h"

#include <gtest/gtest.h>

#include <string>

#include "engine/analysis/workprecision_report.h"

namespace fulcrum::analysis {
namespace {

class Orders : public testing::TestWithParam<WorkStudy (*)(bool)> {};

TEST_P(Orders, AreWithinATenthOfTheory) {
  const WorkStudy study = GetParam()(true);
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

INSTANTIATE_TEST_SUITE_P(Each, Orders, testing::Values(study_field, study_oscillator, study_tumbling));

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

TEST(WorkPrecision, AdvantageComparesAtTheSameCost) {
  WorkStudy study;
  study.points = {{"distance field", 1, 0.01, 10, 0},
                  {"distance field", 2, 0.001, 30, 0},
                  {"classic voxels", 1, 0.5, 5, 0},
                  {"classic voxels", 2, 0.3, 20, 0},
                  {"classic voxels", 3, 0.2, 40, 0}};
  EXPECT_DOUBLE_EQ(advantage(study), 50);  // .5 / .01 at 10 us; .3 / .001 at 30 us
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
}  // namespace fulcrum::analysis
