#pragma once
// Reading and baking a scenario while its window says how far that is.

#include <optional>
#include <string>

#include "engine/app/prepare/prepare.h"
#include "engine/app/run/expert_run.h"
#include "engine/app/window/window_stage.h"

namespace fulcrum::app {

struct PreparedInWindow {
  std::optional<Prepared> prepared;  // none: what is wrong is on stderr, or the window was closed
  std::optional<ExpertRun> expert;   // none: the scenario has none to compare with
  bool closed = false;
  bool cancelled = false;  // by Esc
};

PreparedInWindow prepare_in_window(WindowStage& stage, const std::string& name, scenario::Scenario scenario);

}  // namespace fulcrum::app
