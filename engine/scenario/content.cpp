#include "engine/scenario/content.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <system_error>

#include "engine/assets/importable.h"
#include "engine/scenario/load.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// NAME -> scenario.yaml, over all roots.
std::map<std::string, fs::path> scenario_files(const std::vector<fs::path>& roots) {
  std::map<std::string, fs::path> files;
  for (const fs::path& root : roots) {
    std::error_code error;
    fs::directory_iterator entry(root / "scenarios", error);
    while (!error && entry != fs::directory_iterator()) {
      const fs::path file = entry->path() / kScenarioFile;
      if (is_file(file)) files.emplace(entry->path().filename().string(), file);  // the first root's stays
      entry.increment(error);
    }
  }
  return files;
}

bool is_path(std::string_view name_or_file) {
  return name_or_file.find('/') != name_or_file.npos || name_or_file.ends_with(".yaml") ||
         name_or_file == "." || name_or_file == "..";
}

}  // namespace

std::vector<fs::path> content_roots() {
  std::vector<fs::path> candidates;
  if (const char* given = std::getenv("FULCRUM_CONTENT"); given && *given) candidates.emplace_back(given);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    candidates.push_back(program.parent_path() / "content");
    candidates.push_back(program.parent_path().parent_path() / "share" / "fulcrum" / "content");
  }
  std::erase_if(candidates, [](const fs::path& root) { return !is_folder(root); });
  return candidates;
}

std::vector<ScenarioListing> list_scenarios() {
  return list_scenarios(content_roots());
}

std::vector<ScenarioListing> list_scenarios(const std::vector<fs::path>& roots) {
  std::vector<ScenarioListing> listings;
  for (const auto& [name, file] : scenario_files(roots)) {
    ScenarioListing& listing = listings.emplace_back(
        ScenarioListing{.name = name, .title = {}, .about = {}, .file = file, .fault = {}});
    const auto scenario = load_scenario(file);
    if (scenario) {
      listing.title = scenario->title;
      listing.about = scenario->about;
      listing.difficulty = scenario->difficulty;
      listing.checkpoints = scenario->checkpoints.size();
      listing.time_limit = scenario->time_limit;
    } else {
      listing.fault = scenario.faults().front().text();
    }
  }
  std::ranges::stable_sort(listings, {},
                           [](const ScenarioListing& listing) { return listing.name != kTutorial; });
  return listings;
}

std::map<std::string, fs::path> device_files(const std::vector<fs::path>& roots) {
  std::map<std::string, fs::path> files;
  for (const fs::path& root : roots) {
    std::error_code error;
    fs::directory_iterator entry(root / "devices", error);
    while (!error && entry != fs::directory_iterator()) {
      const fs::path& file = entry->path();
      if (file.extension() == ".yaml" && is_file(file)) files.emplace(file.stem().string(), file);
      entry.increment(error);
    }
  }
  return files;
}

Result<fs::path> find_scenario(std::string_view name_or_file) {
  return find_scenario(name_or_file, content_roots());
}

Result<fs::path> find_scenario(std::string_view name_or_file, const std::vector<fs::path>& roots) {
  const auto files = scenario_files(roots);
  const auto named = files.find(std::string(name_or_file));
  if (named != files.end()) return named->second;
  const fs::path path(name_or_file);
  if (is_importable(path) || path.extension() == ".glb" || path.extension() == ".gltf")
    return Error{in_quotes(name_or_file) + " is a model, and no scenario: " +
                 (is_importable(path) ? "`fulcrum import` makes a .glb of it, and " : "") +
                 "a scenario's `models` name it"};
  if (is_path(name_or_file)) {
    if (is_file(path)) return path;
    if (is_file(path / kScenarioFile)) return path / kScenarioFile;
    return Error{"there is no scenario file " + in_quotes(name_or_file) +
                 "; `fulcrum list` shows the ones that have a name"};
  }
  std::vector<std::string_view> names;
  for (const auto& [name, file] : files) names.push_back(name);
  if (names.empty()) {
    return Error{"there is no scenario " + in_quotes(name_or_file) +
                 ", nor any other: no content folder was found; set FULCRUM_CONTENT to the one of your copy"};
  }
  const auto near = nearest(name_or_file, std::span<const std::string_view>(names));
  return Error{"there is no scenario " + in_quotes(name_or_file) +
               (near ? "; did you mean " + in_quotes(*near) + "?" : std::string(";")) +
               " `fulcrum list` shows them all"};
}

}  // namespace fulcrum::scenario
