// Every kind of fault in a scenario file, word for word: where it points and what it says.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

struct FaultCase {
  const char* name;
  const char* what;
  const char* by;
  const char* fault;  // without the file's name
};

class ScenarioFaults : public testing::TestWithParam<FaultCase> {};

TEST_P(ScenarioFaults, PointAtTheCause) {
  const Folder folder;
  const FaultCase& c = GetParam();
  EXPECT_EQ(faults_of(folder, replaced(kScenario, c.what, c.by)), std::string("scenario.yaml:") + c.fault);
}

const FaultCase kFaultCases[] = {
    {"unknown_key", "  stiffness: 5000", "  stifness: 5000",
     "11:3: unknown key 'contact.stifness'; did you mean 'stiffness'?"},
    {"guidance_without_an_expert", "time_limit: 10", "time_limit: 10\nguidance: {}",
     "5:11: 'guidance' leads along the way of a hand 'expert', which 'hands' does not name: name one, or "
     "leave "
     "guidance out"},
    {"unknown_key_at_top", "time_limit: 10", "time_limit: 10\nseeed: 4",
     "5:1: unknown key 'seeed'; did you mean 'seed'?"},
    {"unknown_key_far_from_any", "  stiffness: 5000", "  colour: red",
     "11:3: unknown key 'contact.colour'; the keys here are response, stiffness, levels, dissipation, "
     "friction, torsional_friction, rolling_friction, region_radius, edges, surface"},
    {"missing_key", "title: Peg\n", "", "1:1: key 'title' is missing: as lists and windows show it"},
    {"missing_key_inside", "{file: block.glb, role: scene}", "{file: block.glb}",
     "6:10: key 'models.block.role' is missing: scene: touched; tool: held in the hand; decor: seen only"},
    {"text_for_a_number", "stiffness: 5000", "stiffness: hard",
     "11:14: 'contact.stiffness' must be a number in N/m; found 'hard'"},
    {"a_unit_written_out", "stiffness: 5000", "stiffness: 5 kN/m",
     "11:14: 'contact.stiffness' must be a number in N/m, digits alone; found '5 kN/m'"},
    {"quotes_around_a_number", "stiffness: 5000", "stiffness: \"5000\"",
     "11:14: 'contact.stiffness' must be a number in N/m, digits alone; found '5000' in quotes"},
    {"list_for_a_number", "stiffness: 5000", "stiffness: [5000]",
     "11:14: 'contact.stiffness' must be a number in N/m; found a list"},
    {"nothing_for_a_number", "stiffness: 5000",
     "stiffness:", "11:3: 'contact.stiffness' must be a number in N/m; found nothing"},
    {"below_the_range", "stiffness: 5000", "stiffness: 0",
     "11:14: 'contact.stiffness' must be above 0 and at most 1e+07 N/m; found '0'"},
    {"above_the_range", "time_limit: 10", "time_limit: 1e6",
     "4:13: 'time_limit' must be above 0 and at most 86400 s; found '1e6'"},
    {"a_difficulty_that_is_none", "time_limit: 10", "difficulty: hrad\ntime_limit: 10",
     "4:13: 'difficulty' must be one of easy, medium, hard; found 'hrad'; did you mean 'hard'?"},
    {"a_need_that_is_none", "radius: 0.005}", "radius: 0.005, needs: stops}",
     "15:61: 'checkpoints.0.needs' must be one of place, touch, stop; found 'stops'; did you mean 'stop'?"},
    {"a_hint_with_a_word_that_is_none", "radius: 0.005}", "radius: 0.005, hint: \"Go: {tunr}.\"}",
     "15:60: 'checkpoints.0.hint' has the word '{tunr}'; did you mean 'turn'?"},
    {"an_arm_of_another_size", "  model: test_arm", "  model: test_arm\n  position_scale: 2\n  drawn: true",
     "15:10: 'device.drawn' needs a position_scale of 1: arms are drawn in their own size"},
    {"drawn_arms_that_drift", "  model: test_arm", "  model: test_arm\n  drift: 0.05\n  drawn: true",
     "15:10: 'device.drawn' needs a drift of 0: drawn arms stand where they are, and cannot creep with the "
     "tool"},
    {"a_drift_as_fast_as_the_hand", "  model: test_arm", "  model: test_arm\n  drift: 1",
     "14:10: 'device.drift' must be at least 0 and at most 0.5; found '1'"},
    {"walls_without_depth", "  model: test_arm", "  model: test_arm\n  workspace_walls: {margin: 0}",
     "14:29: 'device.workspace_walls.margin' must be above 0 and at most 1 m; found '0'"},
    {"nan", "stiffness: 5000", "stiffness: .nan",
     "11:14: 'contact.stiffness' must be a finite number; found '.nan'"},
    {"infinity", "stiffness: 5000", "stiffness: -.inf",
     "11:14: 'contact.stiffness' must be a finite number; found '-.inf'"},
    {"too_large_for_a_number", "stiffness: 5000", "stiffness: 1e999",
     "11:14: 'contact.stiffness' must be a finite number; found '1e999'"},
    {"fraction_for_an_integer", "time_limit: 10", "time_limit: 10\nseed: 1.5",
     "5:7: 'seed' must be a whole number from 0 to 9223372036854775807; found '1.5'"},
    {"integer_out_of_range", "model: test_arm", "model: test_arm\n  clutch_button: 32",
     "14:18: 'device.clutch_button' must be a whole number from -1 to 31; found '32'"},
    {"yes_for_a_boolean", "tool:\n", "tool:\n  weight: yes\n",
     "9:11: 'tool.weight' must be true or false; found 'yes'"},
    {"unknown_choice", "role: scene", "role: scen",
     "6:34: 'models.block.role' must be one of scene, tool, decor; found 'scen'; did you mean 'scene'?"},
    {"unknown_response", "  stiffness: 5000", "  response: constrain",
     "11:13: 'contact.response' must be one of penalty, voxel, static, constraint, direct; found "
     "'constrain'; did you mean 'constraint'?"},
    {"no_levels", "  stiffness: 5000", "  levels: []",
     "11:11: 'contact.levels' must be a list of 1 to 12 numbers in N/m; found 0 values"},
    {"level_below_zero", "  stiffness: 5000", "  levels: [100, -5]",
     "11:17: 'contact.levels' has a component that must be above 0 and at most 1e+07 N/m; found '-5'"},
    {"level_alone", "  stiffness: 5000", "  levels: 100",
     "11:11: 'contact.levels' must be a list of 1 to 12 numbers in N/m; found '100'"},
    {"short_vector", "position: [0, 0.1, 0]", "position: [0, 0.1]",
     "9:21: 'tool.start.position' must be three numbers [x, y, z] in m; found 2 values"},
    {"word_in_a_vector", "position: [0, 0.1, 0]", "position: [0, up, 0]",
     "9:25: 'tool.start.position' has a component that must be a number in m; found 'up'"},
    {"far_away", "position: [0, 0.1, 0]", "position: [0, 1e5, 0]",
     "9:25: 'tool.start.position' has a component that must be at least -1000 and at most 1000 m; found "
     "'1e5'"},
    {"number_for_a_vector", "position: [0, 0.1, 0]", "position: 3",
     "9:21: 'tool.start.position' must be three numbers [x, y, z] in m; found '3'"},
    {"not_a_rotation", "position: [0, 0.1, 0]", "orientation: [2, 0, 0, 0]",
     "9:24: 'tool.start.orientation' must be a unit quaternion [w, x, y, z]; its length is 2; divided by "
     "that it is "
     "[1, 0, 0, 0]"},
    {"rotation_of_no_length", "position: [0, 0.1, 0]", "orientation: [0, 0, 0, 0]",
     "9:24: 'tool.start.orientation' must be a unit quaternion [w, x, y, z]; its length is 0"},
    {"comment_for_a_colour", "views:", "background: {top: red}\nviews:",
     "18:19: 'background.top' must be \"#rrggbb\" (sRGB, in quotes) or three numbers [r, g, b] from 0 to 1 "
     "(linear); "
     "found 'red'"},
    {"colour_too_bright", "views:", "background: {top: [0, 2, 0]}\nviews:",
     "18:23: 'background.top' has a component that must be at least 0 and at most 1; found '2'"},
    {"mapping_for_a_list", "  - {name: hole, position: [0, 0, 0], radius: 0.005}", "  name: hole",
     "15:3: 'checkpoints' must be a list, each element beginning with '- '; found a mapping"},
    {"list_for_a_mapping", "  stiffness: 5000", "  - stiffness",
     "11:3: 'contact' must be a mapping of keys; found a list"},
    {"empty_list", "  - {name: hole, position: [0, 0, 0], radius: 0.005}", "  []",
     "15:3: 'checkpoints' must have at least 1 element"},
    {"name_used_twice", "hands:", "  - {name: hole, position: [0, 0, 1]}\nhands:",
     "16:12: 'checkpoints.1.name' is the name of an earlier one; choose another"},
    {"version_missing", "fulcrum: 1\n", "",
     "1:1: the first line must be 'fulcrum: 1', the version of the file's format"},
    {"version_not_first", "fulcrum: 1\ntitle: Peg\n", "title: Peg\nfulcrum: 1\n",
     "2:1: 'fulcrum' must be the first key, so that any program can tell the file's format"},
    {"version_of_the_future", "fulcrum: 1\ntitle: Peg\n", "fulcrum: 2\ntittle: Peg\n",
     "1:10: format 2 is not known to this program, which reads format 1; take a newer program, or write "
     "'fulcrum: 1'"},
    {"two_tools", "role: scene", "role: tool",
     "6:3: 'models' must have exactly one model with 'role: tool'\n"
     "scenario.yaml:6:3: 'models' must have a model with 'role: scene', something to touch"},
    {"hard_touch_without_a_force", "views:", "hard_touch: {}\nviews:",
     "18:13: key 'hard_touch.force' is missing: of the scene on the tool, above which a touch is too hard"},
    {"cut_that_is_touched", "role: scene", "role: scene, cut_of: peg",
     "6:49: 'models.block.cut_of' is for a model with 'role: decor'"},
    {"cut_of_nothing", "  peg:", "  half: {file: half.glb, role: decor, cut_of: blok}\n  peg:",
     "6:3: 'models' has a 'cut_of' that is not the name of a model with 'role: scene'"},
    {"mass_and_density", "tool:\n", "tool:\n  mass: 1\n  density: 7850\n",
     "9:9: 'tool.mass' and 'tool.density' exclude each other; keep one of them"},
    {"band_of_one_voxel", "contact:", "field: {voxel: 0.004, band: 0.007}\ncontact:",
     "10:29: 'field.band' must be at least two voxels"},
    {"no_direction_to_look", "target: [0, 0, 0]", "target: [0, 0.1, 0.5]",
     "19:47: 'views.0.target' is where the eye is; there is no direction to look in"},
    {"parameter_of_another_estimator",
     "contact:", "velocity_estimator: {name: low_pass, window: 3}\ncontact:",
     "10:38: 'velocity_estimator.window' is a key of 'adaptive_window', not of 'low_pass', which takes name, "
     "cutoff_Hz"},
    {"unknown_estimator", "contact:", "velocity_estimator: {name: lowpass, cutoff_Hz: 3}\ncontact:",
     "10:28: 'velocity_estimator.name' must be one of difference, low_pass, adaptive_window; found "
     "'lowpass'; did you "
     "mean 'low_pass'?"},
    {"unknown_estimator_alone", "contact:", "velocity_estimator: diff\ncontact:",
     "10:21: 'velocity_estimator' must be one of difference, low_pass, adaptive_window; found 'diff'"},
    {"outside_the_folder", "path: sure.yaml", "path: ../other/sure.yaml",
     "17:16: 'hands.sure.path' must name a file in the scenario's own folder; '../other/sure.yaml' leads out "
     "of it; "
     "copy the file there"},
    {"absolute_path", "path: sure.yaml", "path: /etc/passwd",
     "17:16: 'hands.sure.path' must name a file in the scenario's own folder; '/etc/passwd' leads out of it; "
     "copy the "
     "file there"},
    {"the_folder_itself", "path: sure.yaml", "path: .",
     "17:16: 'hands.sure.path' must name a file in the scenario's own folder; '.' is the folder itself"},
    {"missing_hand_path", "path: sure.yaml", "path: shure.yaml",
     "17:16: cannot read 'shure.yaml': No such file or directory; did you mean 'sure.yaml'?"},
    {"missing_device", "model: test_arm", "model: tst_arm",
     "13:10: cannot read 'devices/tst_arm.yaml': No such file or directory; did you mean 'test_arm'?"},
    {"missing_material", "contact:", "impact_vibration: {material: steal}\ncontact:",
     "10:30: cannot read 'materials/steal.yaml': No such file or directory; did you mean 'steel'?"},
    {"missing_material_of_a_model", "role: scene}", "role: scene, material: gold}",
     "6:51: cannot read 'materials/gold.yaml': No such file or directory; there is: steel"},
    {"material_of_the_tool", "role: tool}", "role: tool, material: steel}",
     "7:46: 'models.peg.material' is for a model with 'role: scene'"},
    {"too_many_voices", "contact:", "impact_vibration: {voices: 17}\ncontact:",
     "10:28: 'impact_vibration.voices' must be a whole number from 1 to 16; found '17'"},
    {"device_that_is_a_path", "model: test_arm", "model: ../test_arm",
     "13:10: 'device.model' must be a name of letters, digits, '_' and '-'; found '../test_arm'"},
    {"two_lines_of_text", "title: Peg", "title: \"Peg\\nand hole\"",
     "2:8: 'title' must be one line of text, without tabs; found 'Peg and hole' in quotes"},
    {"duplicate_key", "  stiffness: 5000", "  stiffness: 5000\n  stiffness: 6000",
     "12:3: key 'stiffness' is already given on line 11; remove one of the two"},
    {"alias", "  stiffness: 5000", "  stiffness: &k 5000",
     "11:14: anchor '&k' is not supported; write the value out where it is needed"},
};

std::string name_of_fault(const testing::TestParamInfo<FaultCase>& each) {
  return each.param.name;
}

INSTANTIATE_TEST_SUITE_P(Each, ScenarioFaults, testing::ValuesIn(kFaultCases), name_of_fault);

TEST(ScenarioFaultsTogether, AreAllReported) {
  const Folder folder;
  std::string text = replaced(kScenario, "stiffness: 5000", "stiffness: hard");
  text = replaced(text, "time_limit: 10", "time_limit: -1");
  text = replaced(text, "radius: 0.005", "radios: 0.005");
  folder.write("scenarios/peg/sure.yaml", "fulcrum: 1\nwaypoints: [{travel: 0}]\n");
  folder.write("scenarios/peg/devices/test_arm.yaml", "fulcrum: 1\nmax_forse: 3\n");
  EXPECT_EQ(faults_of(folder, text),
            "scenario.yaml:4:13: 'time_limit' must be above 0 and at most 86400 s; found '-1'\n"
            "scenario.yaml:11:14: 'contact.stiffness' must be a number in N/m; found 'hard'\n"
            "scenario.yaml:15:39: unknown key 'checkpoints.0.radios'; did you mean 'radius'?\n"
            "sure.yaml:2:22: 'waypoints.0.travel' must be above 0 and at most 3600 s; found '0'\n"
            "devices/test_arm.yaml:1:1: key 'name' is missing: as panels and results show it\n"
            "devices/test_arm.yaml:2:1: unknown key 'max_forse'; did you mean 'max_force'?");
}

// A hand that never took the force up again would stand still for ever.
TEST(ScenarioFaultsTogether, OfAStopThatDoesNotEnd) {
  const Folder folder;
  const auto rests = [&](const char* stop) {
    folder.write(
        "scenarios/peg/sure.yaml",
        std::string("fulcrum: 1\nwaypoints:\n  - {position: [0, 0.1, 0], dwell: 0.5, stop: ") + stop + "}\n");
    return faults_of(folder, kScenario);
  };
  EXPECT_EQ(rests("0.4"), "");
  EXPECT_EQ(
      rests("0.45"),
      "sure.yaml:3:47: 'waypoints.0.stop' must end 0.1 s before 'dwell' does, so that the hand takes the "
      "force up again");
}

TEST(ScenarioFaultsTogether, OfATextThatIsNoScenario) {
  const Folder folder;
  EXPECT_EQ(
      faults_of(folder, "hello"),
      "scenario.yaml:1:1: a file must hold a mapping of keys, one 'key: value' to a line; found 'hello'");
  EXPECT_NE(faults_of(folder, ""), "");
  EXPECT_NE(faults_of(folder, std::string("\0\0\0", 3)), "");
}

// A symbolic link is followed before it is judged: it may not lead out, and it may lead about inside.
TEST(ScenarioFaultsTogether, LinksLeadNowhereElse) {
  const Folder folder;
  folder.write("elsewhere.yaml", kHandPath);
  std::filesystem::create_symlink("../../elsewhere.yaml", folder.peg() / "out.yaml");
  std::filesystem::create_symlink("sure.yaml", folder.peg() / "in.yaml");
  EXPECT_EQ(faults_of(folder, replaced(kScenario, "path: sure.yaml", "path: out.yaml")),
            "scenario.yaml:17:16: 'hands.sure.path' must name a file in the scenario's own folder; "
            "'out.yaml' leads out "
            "of it; copy the file there");
  EXPECT_EQ(faults_of(folder, replaced(kScenario, "path: sure.yaml", "path: in.yaml")), "");
  EXPECT_EQ(faults_of(folder, replaced(kScenario, "path: sure.yaml", "path: ../peg/sure.yaml")), "");
}

}  // namespace
}  // namespace fulcrum::scenario::test
