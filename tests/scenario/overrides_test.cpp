#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

using Overrides = std::vector<std::string>;

Scenario read(const Folder& folder, const Overrides& overrides) {
  auto scenario = load_scenario_text(kScenario, folder.peg(), overrides);
  if (!scenario) ADD_FAILURE() << to_text(scenario.faults());
  return scenario ? std::move(*scenario) : Scenario{};
}

TEST(Overrides, SetByFullPathOrByItsEnd) {
  const Folder folder;
  const Scenario scenario = read(folder, {
                                             "contact.stiffness=700",       // in the file
                                             "coupling.stiffness=800",      // its mapping is not in the file
                                             "region_radius=0.02",          // the only key that ends so
                                             "response=penalty",            //
                                             "start.position=[0, 0.2, 0]",  // the end of a path, a list
                                             "checkpoints.0.radius=0.5",    //
                                             "hands.sure.tremor=0",         //
                                             "title=Another peg",           //
                                             "background.top=#ff0000",      // would be a comment in a file
                                             "seed=1", "seed=7",            // the last one holds
                                         });
  EXPECT_EQ(scenario.contact.stiffness, 700);
  EXPECT_EQ(scenario.coupling.stiffness, 800);
  EXPECT_EQ(scenario.contact.region_radius, 0.02);
  EXPECT_EQ(scenario.tool.X_WM_start.p, Vec3(0, 0.2, 0));
  EXPECT_EQ(scenario.checkpoints[0].radius, 0.5);
  EXPECT_EQ(scenario.hands[0].desc.tremor, 0);
  EXPECT_EQ(scenario.title, "Another peg");
  EXPECT_EQ(scenario.background.top, glm::vec3(1, 0, 0));
  EXPECT_EQ(scenario.seed, 7);
  EXPECT_EQ(scenario.hands[0].desc.seed, 7u);
  EXPECT_EQ(scenario.overrides.size(), 11u);
}

TEST(Overrides, ReplaceAnEstimatorWhole) {
  const Folder folder;
  const std::string text =
      replaced(kScenario, "contact:", "velocity_estimator: {name: low_pass, cutoff_Hz: 3}\ncontact:");
  const auto difference = load_scenario_text(text, folder.peg(), Overrides{"velocity_estimator=difference"});
  ASSERT_TRUE(difference) << to_text(difference.faults());
  EXPECT_EQ(difference->velocity_estimator.kind, VelocityEstimatorKind::difference);
  // The short form, given first, is written out when one of its parameters follows.
  const auto window = load_scenario_text(
      text, folder.peg(), Overrides{"velocity_estimator=adaptive_window", "velocity_estimator.window=9"});
  ASSERT_TRUE(window) << to_text(window.faults());
  EXPECT_EQ(window->velocity_estimator.kind, VelocityEstimatorKind::adaptive_window);
  EXPECT_EQ(window->velocity_estimator.window, 9);
}

struct OverrideFaultCase {
  const char* name;
  const char* override;
  const char* fault;  // after "--set OVERRIDE: "
};

class OverrideFaults : public testing::TestWithParam<OverrideFaultCase> {};

TEST_P(OverrideFaults, SaySo) {
  const Folder folder;
  const OverrideFaultCase& c = GetParam();
  EXPECT_EQ(faults_of(folder, kScenario, {c.override}), "--set " + std::string(c.override) + ": " + c.fault);
}

const OverrideFaultCase kOverrideFaultCases[] = {
    {"no_value", "stiffness", "an override is written KEY=VALUE, for instance contact.stiffness=5000"},
    {"no_key", "=3", "an override is written KEY=VALUE, for instance contact.stiffness=5000"},
    {"unknown", "contact.stifness=3", "unknown key 'contact.stifness'; did you mean 'contact.stiffness'?"},
    {"unknown_end", "respnse=penalty", "unknown key 'respnse'; did you mean 'contact.response'?"},
    {"unknown_far", "viscosity=3", "unknown key 'viscosity'; `fulcrum schema` lists the keys"},
    {"ambiguous", "stiffness=3",
     "key 'stiffness' could be any of contact.stiffness, coupling.stiffness, "
     "device.workspace_walls.stiffness, guidance.stiffness, hands.N.stiffness; write it out"},
    {"in_a_list", "fov_deg=30",
     "key 'fov_deg' is in a list or under a name; write it out as views.N.fov_deg, with the number, from "
     "0, or the "
     "name for N"},
    {"no_such_element", "checkpoints.1.radius=3",
     "'checkpoints' has 1 elements, numbered from 0; there is no '1'"},
    {"no_number", "checkpoints.hole.radius=3",
     "'checkpoints' has 1 elements, numbered from 0; there is no 'hole'"},
    {"no_such_name", "hands.shure.tremor=0", "'hands' has no 'shure'; did you mean 'sure'?"},
    {"no_names_at_all", "materials.steel.roughness=0", "'materials' has no 'steel'; it is empty"},
    {"wrong_type", "contact.stiffness=soft", "'contact.stiffness' must be a number in N/m; found 'soft'"},
    {"out_of_range", "dwell=-1", "'dwell' must be at least 0 and at most 600 s; found '-1'"},
    {"empty", "dwell=", "'dwell' must be a number in s; found nothing"},
    {"not_yaml", "dwell=[1",
     "a list or mapping stands where a key should, which is plain text; is a closing bracket missing?"},
    {"outside", "hands.sure.path=../../x",
     "'hands.sure.path' must name a file in the scenario's own folder; '../../x' leads out of it; copy the "
     "file there"},
    {"anchor", "dwell=&a 1", "anchor '&a' is not supported; write the value out where it is needed"},
    {"key_inside_a_value", "contact={stifness: 3}",
     "unknown key 'contact.stifness'; did you mean 'stiffness'?"},
};

std::string name_of_override(const testing::TestParamInfo<OverrideFaultCase>& each) {
  return each.param.name;
}

INSTANTIATE_TEST_SUITE_P(Each, OverrideFaults, testing::ValuesIn(kOverrideFaultCases), name_of_override);

TEST(Overrides, AreNamedOnOneLine) {
  const Folder folder;
  const std::string faults = faults_of(folder, kScenario, {"none\n\x1b[2J=1"});
  EXPECT_TRUE(faults.starts_with("--set none  [2J=1: unknown key 'none  [2J'")) << faults;
}

}  // namespace
}  // namespace fulcrum::scenario::test
