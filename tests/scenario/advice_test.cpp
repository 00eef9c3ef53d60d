// What is said of a scenario before anyone plays it. The truth is the scene's own make: a block whose upper
// face is y = 0, a peg of 40 mm that stands on its touch point, and a device that reaches 80 mm.

#include "engine/scenario/advice.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/scenario/box_glb.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

class AdviceTest : public testing::Test {
protected:
  AdviceTest() {
    folder_.write("scenarios/peg/block.glb", box_glb({-0.1F, -0.02F, -0.1F}, {0.1F, 0.0F, 0.1F}));
    folder_.write("scenarios/peg/peg.glb", box_glb({-0.005F, 0.0F, -0.005F}, {0.005F, 0.04F, 0.005F}));
  }

  std::vector<Advice> advice(const std::vector<std::string>& overrides) {
    const auto scenario = load_scenario_text(kScenario, folder_.peg(), overrides);
    if (!scenario) ADD_FAILURE() << to_text(scenario.faults());
    const auto models = load_models(*scenario);
    const auto haptic = assemble_haptic(*scenario, *models, BakeCache(folder_.root() / "cache"));
    if (!haptic) ADD_FAILURE() << haptic.error().sentence;
    return advise(*haptic);
  }

  // Of one advice: what it is about and how grave; empty: there is none.
  std::string about(const std::vector<std::string>& overrides) {
    const std::vector<Advice> found = advice(overrides);
    std::string text;
    for (const Advice& each : found)
      text += each.key + (each.severity == Severity::error     ? ": error"
                          : each.severity == Severity::warning ? ": warning"
                                                               : ": note");
    return text;
  }

  Folder folder_;
};

TEST_F(AdviceTest, IsSilentOnAGoodScenario) {
  EXPECT_EQ(about({}), "");
}

TEST_F(AdviceTest, AStartInTheSceneIsAnError) {
  EXPECT_EQ(about({"tool.start.position=[0, -0.01, 0]"}), "tool.start: error");
  EXPECT_NE(advice({"tool.start.position=[0, -0.003, 0]"})[0].sentence.find("3 mm deep"), std::string::npos);
  EXPECT_EQ(about({"tool.start.position=[0, -0.0002, 0]"}), "tool.start: warning");
  EXPECT_EQ(about({"tool.start.position=[0, 0, 0]"}), "");
}

TEST_F(AdviceTest, ACheckpointInTheSceneIsAnError) {
  EXPECT_EQ(about({"checkpoints.0.position=[0, -0.01, 0]"}), "checkpoints.0.position: error");
  EXPECT_EQ(about({"checkpoints.0.position=[0, -0.004, 0]"}), "") << "within its radius there is room";
  // Inside a ring-shaped tool there may be something of the scene: then only poses tell.
  EXPECT_EQ(about({"checkpoints.0.position=[0, -0.01, 0]", "tool.touch_point=[0, -0.02, 0]"}), "");
}

TEST_F(AdviceTest, ACheckpointThatOnlyPosesTellOfIsAWarning) {
  // The touch point is 3 mm before the peg's foot, and 10 mm of the block are on either side of it.
  EXPECT_EQ(about({"checkpoints.0.position=[0, -0.01, 0]", "tool.touch_point=[0, -0.003, 0]",
                   "checkpoints.0.radius=0.001"}),
            "checkpoints.0.position: warning");
}

TEST_F(AdviceTest, ACheckpointOutOfTheDevicesReachIsAWarning) {
  const std::string key = "checkpoints.0.position";
  EXPECT_EQ(about({key + "=[0.07, 0, 0]"}), "");
  EXPECT_EQ(about({key + "=[0.2, 0, 0]"}), key + ": warning");
  EXPECT_NE(
      advice({key + "=[0.2, 0.05, 0]"})[0].sentence.find("out of the workspace of the device 'Test arm'"),
      std::string::npos);
  EXPECT_EQ(about({key + "=[0.2, 0, 0]", "device.position_scale=4"}), "");
  EXPECT_EQ(about({key + "=[0.2, 0, 0]", "device.clutch_button=0"}), "") << "the hand comes along";
}

TEST_F(AdviceTest, WaypointsAfterTheEndAreNoted) {
  const std::string path(kHandPath);
  folder_.write("scenarios/peg/sure.yaml", replaced(path, "travel: 2}", "travel: 2, dwell: 4}"));
  EXPECT_EQ(about({}), "");
  folder_.write("scenarios/peg/sure.yaml",
                replaced(path, "travel: 2}", "travel: 2, dwell: 4}\n  - {position: [0, 0.1, 0]}"));
  EXPECT_EQ(about({}), "hands.sure.path: note");
  folder_.write("scenarios/peg/sure.yaml",
                replaced(path, "travel: 2}", "travel: 2, dwell: 1}\n  - {position: [0, 0.1, 0]}"));
  EXPECT_EQ(about({}), "") << "it leaves too soon, and so has not ended";
}

}  // namespace
}  // namespace fulcrum::scenario::test
