#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"

namespace fulcrum::app {
namespace {

struct CheckedFile {
  scenario::Faults faults;
  std::vector<std::string> told;  // sentences: what was mended of models, and what may not be meant
};

// What is wrong with one file: its text first, and once that is right the models it names.
CheckedFile look_at(const std::string& name_or_file) {
  const Result<std::filesystem::path> file = scenario::find_scenario(name_or_file);
  if (!file) return {{{name_or_file, 0, 0, file.error().sentence}}, {}};
  const scenario::Checked<scenario::Scenario> loaded = scenario::load_scenario(*file);
  if (!loaded) return {loaded.faults(), {}};
  Result<scenario::LoadedModels> models = scenario::load_models(*loaded);
  if (!models) return {{{file->string(), 0, 0, models.error().sentence}}, {}};
  const Result<Solid> scene = scenario::build_scene_solid(*loaded, *models);
  if (!scene) return {{{file->string(), 0, 0, scene.error().sentence}}, {}};
  CheckedFile checked;
  for (const auto& some : {models->warnings, models->repaired, scene->notes})
    checked.told.insert(checked.told.end(), some.begin(), some.end());
  return checked;
}

int check_command(const std::vector<std::string>& files, bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  bool good = true;
  for (const std::string& file : files) {
    const CheckedFile checked = look_at(file);
    good = good && checked.faults.empty();
    for (const scenario::Fault& fault : checked.faults)
      if (json)
        all.push_back({{"file", fault.file},
                       {"line", fault.line},
                       {"column", fault.column},
                       {"severity", "error"},
                       {"sentence", fault.sentence}});
      else
        std::printf("%s\n", fault.text().c_str());
    if (!json && checked.faults.empty()) std::printf("%s: good\n", file.c_str());
    for (const std::string& sentence : checked.told)
      if (json)
        all.push_back(
            {{"file", file}, {"line", 0}, {"column", 0}, {"severity", "note"}, {"sentence", sentence}});
      else
        std::printf("  %s\n", sentence.c_str());
  }
  if (json) std::printf("%s\n", all.dump(2).c_str());
  return good ? kCompleted : kError;
}

}  // namespace

void add_check(Program& program) {
  const auto files = std::make_shared<std::vector<std::string>>();
  const auto json = std::make_shared<bool>(false);
  program.add(
      "check", "Say what is wrong with scenarios",
      [files, json](Arguments& arguments) {
        arguments.required({"files", "FILE", "Scenario files or names"}, *files);
        arguments.json("As JSON", *json);
      },
      [files, json] { return check_command(*files, *json); });
}

}  // namespace fulcrum::app
