#pragma once
// Training in a window that is there: a scenario is made ready, then attempt follows attempt.

#include "engine/app/cli/run_options.h"
#include "engine/app/run/trial_results.h"
#include "engine/app/window/training_window.h"
#include "engine/app/window/window_stage.h"

namespace fulcrum::app {

struct Trained {
  int code = 0;  // the exit code of the last attempt
  TrainingWindow::Leave
      leave;  // closed: the person is done; start_page: back to it, also where nothing could run
};

// participation: null, and nobody's results are kept. What is wrong is on stderr.
Trained train(WindowStage& stage, const scenario::Scenario& scenario, const RunOptions& options,
              Participation* participation, bool has_start_page);

}  // namespace fulcrum::app
