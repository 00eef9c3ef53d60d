#pragma once
// The subcommands. Each returns the program's exit code.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/app/cli/run_options.h"
#include "engine/app/commands/compare_options.h"
#include "engine/app/commands/hardness_options.h"

namespace fulcrum::app {

int list_command(bool json);
int run_command(const RunOptions& options);
int replay_command(const std::filesystem::path& tape, const RunOptions& options);
int check_command(const std::vector<std::string>& files, bool json);
int explain_command(const std::string& scenario, const std::vector<std::string>& overrides, bool json);
int devices_command(bool json);
int compare_command(const CompareOptions& options);
int ambiguity_command(const RunOptions& options);  // its scenario, overrides, out and force
int hardness_command(const HardnessOptions& options);
int stability_command(const RunOptions& options);      // its out, force and json
int workprecision_command(const RunOptions& options);  // likewise
int strip_command(const std::string& device, const std::string& presses);
int uniformity_command(const RunOptions& options);  // its out and force
int schema_command(const std::string& of);          // scenario, hand, device or material

}  // namespace fulcrum::app
