#include "tests/fuzz/scenario_answer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/scenario/example.h"

namespace fulcrum::scenario::fuzz {
namespace {

void expect(bool holds) {
  if (!holds) std::abort();
}

bool lies_in(const std::filesystem::path& folder, const std::filesystem::path& file) {
  return std::ranges::mismatch(folder, file).in1 == folder.end() && file != folder;
}

bool is_unit(const Vec3& v) {
  return std::abs(v.norm() - 1) < 1e-9;
}

void expect_sound(const Checkpoint& checkpoint) {
  expect(checkpoint.position.allFinite() && checkpoint.radius > 0);
  for (const Vec3& corner : checkpoint.follow) expect(corner.allFinite());
  if (checkpoint.insert) expect(is_unit(checkpoint.insert->direction_W) && checkpoint.insert->depth > 0);
  if (checkpoint.turn) expect(is_unit(checkpoint.turn->axis_W) && checkpoint.turn->angle > 0);
  if (checkpoint.force) expect(checkpoint.force->least < checkpoint.force->most);
  if (checkpoint.facing) expect(std::abs(checkpoint.facing->q_WT.norm() - 1) < 1e-9);
}

void expect_sound(const Scenario& scenario) {
  expect(scenario.time_limit > 0 && std::isfinite(scenario.time_limit));
  expect(scenario.tick_rate_Hz >= kSlowestTicks_Hz && scenario.tick_rate_Hz <= kFastestTicks_Hz);
  expect(scenario.tool.X_WM_start.is_finite());
  expect(std::ranges::count(scenario.models, ModelRole::tool, &ModelEntry::role) == 1);
  for (const ModelEntry& model : scenario.models) expect(lies_in(scenario.folder, model.file.path));
  expect(!scenario.checkpoints.empty());
  for (const Checkpoint& checkpoint : scenario.checkpoints) expect_sound(checkpoint);
  expect(!std::ranges::all_of(scenario.checkpoints, &Checkpoint::optional));
  for (const HandEntry& hand : scenario.hands) {
    expect(lies_in(scenario.folder, hand.path.path) && !hand.waypoints.empty());
    for (const Waypoint& waypoint : hand.waypoints) expect(waypoint.X_WT.is_finite());
  }
}

// How many lines a text can have, whatever it takes for the end of one.
int lines_of(const std::string& text) {
  return static_cast<int>(std::ranges::count(text, '\n') + std::ranges::count(text, '\r')) + 2;
}

}  // namespace

SourceTexts example_with(const std::string& file, std::string_view input) {
  static const std::string scenario =
      test::replaced(test::kScenario, "contact:", "impact_vibration: {}\ncontact:");
  SourceTexts texts{"scenario.yaml",
                    {{"scenario.yaml", scenario},
                     {"sure.yaml", test::kHandPath},
                     {"devices/test_arm.yaml", test::kDevice},
                     {"materials/steel.yaml", test::kMaterial}}};
  texts.files[file] = input;
  return texts;
}

void expect_answer(const Checked<Scenario>& answer, const SourceTexts& texts) {
  if (answer) return expect_sound(*answer);
  expect(!answer.faults().empty());
  for (const Fault& fault : answer.faults()) {
    expect(!fault.sentence.empty() && !fault.file.empty() && fault.text().find('\n') == std::string::npos);
    const auto text = texts.files.find(fault.file);
    if (text != texts.files.end()) expect(fault.line >= 0 && fault.line <= lines_of(text->second));
  }
}

void read_example_with(const std::string& file, std::string_view input) {
  const SourceTexts texts = example_with(file, input);
  expect_answer(load_scenario_texts(texts, "/nowhere"), texts);
}

}  // namespace fulcrum::scenario::fuzz
