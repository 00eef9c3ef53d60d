#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/schema.h"

namespace fulcrum::app {
namespace {

// What is wrong with one file: its text first, and once that is right the models it names.
scenario::Faults faults_of(const std::string& name_or_file) {
  const Result<std::filesystem::path> file = scenario::find_scenario(name_or_file);
  if (!file) return {{name_or_file, 0, 0, file.error().sentence}};
  const scenario::Checked<scenario::Scenario> loaded = scenario::load_scenario(*file);
  if (!loaded) return loaded.faults();
  const Result<scenario::LoadedModels> models = scenario::load_models(*loaded);
  if (!models) return {{file->string(), 0, 0, models.error().sentence}};
  return {};
}

}  // namespace

int check_command(const std::vector<std::string>& files, bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  bool good = true;
  for (const std::string& file : files) {
    const scenario::Faults faults = faults_of(file);
    good = good && faults.empty();
    for (const scenario::Fault& fault : faults) {
      if (json)
        all.push_back({{"file", fault.file},
                       {"line", fault.line},
                       {"column", fault.column},
                       {"sentence", fault.sentence}});
      else
        std::printf("%s\n", fault.text().c_str());
    }
    if (!json && faults.empty()) std::printf("%s: good\n", file.c_str());
  }
  if (json) std::printf("%s\n", all.dump(2).c_str());
  return good ? kCompleted : kError;
}

int schema_command(const std::string& of) {
  const std::string schema = of == "hand"       ? scenario::hand_path_schema()
                             : of == "device"   ? scenario::device_schema()
                             : of == "material" ? scenario::material_schema()
                                                : scenario::scenario_schema();
  std::printf("%s\n", schema.c_str());
  return kCompleted;
}

}  // namespace fulcrum::app
