#pragma once
// Where scenarios are found.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/scenario.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

inline constexpr const char* kScenarioFile = "scenario.yaml";

// Folders that hold scenarios/ and devices/, the first one first: $FULCRUM_CONTENT, content beside the
// program,
// ../share/fulcrum/content from the program. Those that do not exist are left out.
std::vector<std::filesystem::path> content_roots();

struct ScenarioListing {
  std::string name;  // of its folder: what find_scenario() takes
  std::string title;
  std::string about;
  std::filesystem::path file;
  std::string fault;  // the first sentence about it, if it cannot be read
  std::optional<Difficulty> difficulty{};
  std::size_t checkpoints = 0;
  double time_limit = 0;  // s
};

// The scenario that whoever is new begins with.
inline constexpr std::string_view kTutorial = "tutorial";

// Every ROOT/scenarios/NAME/scenario.yaml: the tutorial, then by name; a name that two roots have is the
// first root's.
std::vector<ScenarioListing> list_scenarios();
std::vector<ScenarioListing> list_scenarios(const std::vector<std::filesystem::path>& roots);

// Every ROOT/devices/NAME.yaml by NAME; one that two roots have is the first root's.
std::map<std::string, std::filesystem::path> device_files(const std::vector<std::filesystem::path>& roots);

// A scenario's name, or the path of its file or of the folder it lies in.
Result<std::filesystem::path> find_scenario(std::string_view name_or_file);
Result<std::filesystem::path> find_scenario(std::string_view name_or_file,
                                            const std::vector<std::filesystem::path>& roots);

}  // namespace fulcrum::scenario
