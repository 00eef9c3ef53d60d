#pragma once
// `fulcrum run SCENE --xr`, of which fulcrum knows nothing but that another program does it.

#include "engine/app/cli/run_options.h"
#include "engine/app/run/trial_results.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::headset {

// The program's exit code.
int run_in_headset(const scenario::Scenario& scenario, const app::RunOptions& options,
                   app::Participation* participation);

}  // namespace fulcrum::headset
