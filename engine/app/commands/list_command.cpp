#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/scenario/content.h"

namespace fulcrum::app {

namespace {

int list_command(bool json) {
  const std::vector<scenario::ScenarioListing> scenarios = scenario::list_scenarios();
  if (json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const scenario::ScenarioListing& s : scenarios)
      all.push_back(
          {{"name", s.name},
           {"title", s.title},
           {"about", s.about},
           {"difficulty", s.difficulty ? nlohmann::ordered_json(name_of(*s.difficulty)) : nullptr},
           {"checkpoints", s.checkpoints},
           {"time_limit_s", s.time_limit},
           {"file", s.file.string()},
           {"fault", s.fault.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(s.fault)}});
    std::printf("%s\n", all.dump(2).c_str());
    return kCompleted;
  }
  if (scenarios.empty()) {
    complain(
        "no scenarios were found. Build them (tools/run --build), or set FULCRUM_CONTENT to a content "
        "folder.");
    return kError;
  }
  std::size_t width = 0;
  for (const scenario::ScenarioListing& s : scenarios) width = std::max(width, s.name.size());
  for (const scenario::ScenarioListing& s : scenarios) {
    const std::string padding(width - s.name.size(), ' ');
    const std::string line = s.fault.empty() ? s.title + ". " + dim(s.about) : "cannot be used: " + s.fault;
    const std::string difficulty(s.difficulty ? name_of(*s.difficulty) : "");
    std::printf("%s%s  %-6s  %s\n", bold(s.name).c_str(), padding.c_str(), difficulty.c_str(), line.c_str());
  }
  return kCompleted;
}

}  // namespace

void add_list(Program& program) {
  const auto json = std::make_shared<bool>(false);
  program.add(
      "list", "The scenarios, a line each",
      [json](Arguments& arguments) { arguments.json("As JSON", *json); },
      [json] { return list_command(*json); });
}

}  // namespace fulcrum::app
