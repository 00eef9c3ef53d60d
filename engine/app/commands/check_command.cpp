#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/files/plain_text.h"
#include "engine/render/look.h"
#include "engine/render/validate.h"
#include "engine/scenario/advice.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/surroundings_file.h"
#include "engine/scenario/words.h"
#include "haptics/world/world.h"

namespace fulcrum::app {
namespace {

struct CheckedFile {
  scenario::Faults faults;    // a run would be refused, or cannot go well
  scenario::Faults warnings;  // it runs, and may not do what its author wants
  scenario::Faults notes;     // what was mended of models, and what is worth knowing

  scenario::Faults& of(scenario::Severity severity) {
    return severity == scenario::Severity::error     ? faults
           : severity == scenario::Severity::warning ? warnings
                                                     : notes;
  }
  void take(const scenario::Faults& from, scenario::Faults CheckedFile::*to) {
    (this->*to).insert((this->*to).end(), from.begin(), from.end());
  }
};

// Which key a refusal of the assembly is about, by how it begins.
std::string_view key_of(std::string_view refusal) {
  constexpr std::pair<std::string_view, std::string_view> kKeys[] = {{"contact.edges", "contact.edges"},
                                                                     {"the tool's pointshell", "shell"},
                                                                     {"the scene's distance", "field"}};
  for (const auto& [begins, key] : kKeys)
    if (refusal.starts_with(begins)) return key;
  return {};
}

// Materials that light is to spread below, and that are drawn in a way that has none of this.
void look_for_light_below(const scenario::Scenario& scenario, const render::VisualDesc& desc,
                          CheckedFile& checked) {
  for (const scenario::MaterialOverride& override : scenario.materials) {
    if (override.scatter_distance == Vec3::Zero()) continue;
    const bool all_do = std::ranges::all_of(desc.instances, [&](const render::Instance& instance) {
      const render::Material& material = desc.materials[instance.material];
      return material.name != override.name || render::is_scattering(render::look_of(material).value_or(0));
    });
    if (!all_do)
      checked.warnings.push_back(override.where.fault(
          "'scatter_distance' does nothing where the material " + scenario::in_quotes(override.name) +
          " is metal, is unlit, or is seen through by its alpha or its transmission: export it opaque, say "
          "'metallic: 0' if it is no metal, or leave the key out."));
  }
}

// What `run` does before its first tick, and what it finds out in it.
void look_at_assembly(const scenario::Inspected& inspected, const scenario::LoadedModels& models,
                      CheckedFile& checked) {
  const scenario::Scenario& scenario = inspected.scenario;
  ProgressBar bar;
  const Result<scenario::HapticAssembly> haptic = scenario::assemble_haptic(
      scenario, models, BakeCache(),
      [&](std::string_view what, double fraction) { bar.show("Baking the " + std::string(what), fraction); });
  bar.clear();
  if (!haptic) {
    const scenario::Checked<Solid> scene = scenario::build_scene_solid(scenario, models);
    const std::string& refusal = haptic.error().sentence;
    checked.faults =
        scene ? scenario::Faults{inspected.place(key_of(refusal)).fault(refusal)} : scene.faults();
    return;
  }
  const auto at = [&](std::string_view key, const std::string& sentence) {
    return inspected.place(key).fault(sentence);
  };
  for (const std::string& warning : haptic->warnings) checked.warnings.push_back(at("", warning));
  for (const scenario::Advice& advice : scenario::advise(*haptic))
    checked.of(advice.severity)
        .push_back(at(advice.key, scenario::in_quotes(advice.key) + " " + advice.sentence));
  for (const std::string& note : haptic->repaired)
    if (std::ranges::none_of(models.repaired, [&](const auto& fault) { return fault.text() == note; }))
      checked.notes.push_back(at("models", note));
  if (const Result<World> world = World::build(haptic->scene); !world)
    checked.faults.push_back(at("", world.error().sentence));
  const auto visual = scenario::assemble_visual(scenario, models, haptic->scene);
  if (!visual) {
    checked.take(visual.faults(), &CheckedFile::faults);
    return;
  }
  if (const auto refused = render::validate(visual->desc))
    checked.faults.push_back(at("models", refused->sentence));
  look_for_light_below(scenario, visual->desc, checked);
}

// As they stand in the scenario's own file, and then those of the files that it names.
void sort_by_place(scenario::Faults& faults, const std::string& scenario) {
  const auto place = [&](const scenario::Fault& fault) {
    return std::tuple(fault.file != scenario, fault.file, fault.line, fault.column);
  };
  std::ranges::stable_sort(faults, {}, place);
}

// All that is wrong with one file: its texts and its models, and once those are right what becomes of them.
CheckedFile look_at(const std::string& name_or_file) {
  const Result<std::filesystem::path> file = scenario::find_scenario(name_or_file);
  if (!file) return {{{name_or_file, 0, 0, file.error().sentence}}, {}, {}};
  const scenario::Inspected inspected = scenario::inspect_scenario(*file);
  CheckedFile checked;
  checked.faults = inspected.faults;
  const scenario::Checked<scenario::LoadedModels> models = scenario::load_models(inspected.scenario);
  if (!models) checked.take(models.faults(), &CheckedFile::faults);
  if (models) checked.take(models->warnings, &CheckedFile::warnings);
  if (const auto& around = inspected.scenario.surroundings; around && !around->file.path.empty())
    if (const auto read = scenario::read_surroundings(inspected.scenario, *around); !read)
      checked.take(read.faults(), &CheckedFile::faults);
  if (!checked.faults.empty()) {
    sort_by_place(checked.faults, file->string());
    return checked;
  }
  checked.take(models->repaired, &CheckedFile::notes);
  checked.take(models->lights, &CheckedFile::notes);
  look_at_assembly(inspected, *models, checked);
  return checked;
}

nlohmann::ordered_json as_json(const CheckedFile& checked) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const auto add = [&all](const scenario::Faults& faults, std::string_view severity) {
    for (const scenario::Fault& fault : faults)
      all.push_back({{"file", fault.file},
                     {"line", fault.line},
                     {"column", fault.column},
                     {"severity", severity},
                     {"sentence", fault.sentence}});
  };
  add(checked.faults, "error");
  add(checked.warnings, "warning");
  add(checked.notes, "note");
  return all;
}

// Names in models may hold what a terminal would obey.
std::string shown(const scenario::Fault& fault) {
  return plain_text(fault.text());
}

void print(const std::string& file, const CheckedFile& checked) {
  for (const scenario::Fault& fault : checked.faults) std::printf("%s\n", shown(fault).c_str());
  if (checked.faults.empty()) std::printf("%s: good\n", file.c_str());
  for (const scenario::Fault& warning : checked.warnings)
    std::printf("  %s %s\n", yellow("warning:").c_str(), shown(warning).c_str());
  for (const scenario::Fault& note : checked.notes) std::printf("  %s\n", shown(note).c_str());
}

int check_command(const std::vector<std::string>& files, bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  bool good = true;
  for (const std::string& file : files) {
    const CheckedFile checked = look_at(file);
    good = good && checked.faults.empty();
    if (json)
      for (auto& each : as_json(checked)) all.push_back(std::move(each));
    else
      print(file, checked);
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
