#pragma once
// Whether a run can be had as it is asked for: known before anything is baked or opened.

#include <filesystem>
#include <optional>
#include <string>

#include "engine/app/cli/run_options.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::app {

struct RequestedRun {
  std::optional<scenario::Scenario> scenario;  // none: what is wrong is on stderr
  std::filesystem::path calibration{};         // of the device in hand; empty: none
  int code = 0;                                // where there is none, the program's exit code
};

// options: its device becomes the registry's name, and what follows from it joins the overrides.
// no_window_reason: empty where a window will be there.
RequestedRun request_run(RunOptions& options, const std::string& no_window_reason);

}  // namespace fulcrum::app
