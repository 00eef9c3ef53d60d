#pragma once
// An author's session in a window: the scenario runs, and after each good save it goes on as saved.

#include <filesystem>

#include "engine/app/cli/run_options.h"
#include "engine/app/window/window_stage.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::app {

// file: the scenario's. calibration: as load_scenario() takes it. What is wrong at the beginning is on
// stderr, later on the screen. The program's exit code.
int edit_in_window(WindowStage& stage, const scenario::Scenario& scenario, const std::filesystem::path& file,
                   const std::filesystem::path& calibration, const RunOptions& options);

}  // namespace fulcrum::app
