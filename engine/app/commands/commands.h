#pragma once
// The subcommands. Each adds itself to the program, with its options.

#include "engine/app/cli/program.h"
#include "engine/app/run/trial_results.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::app {

void add_start(Program& program);  // without arguments
void add_list(Program& program);
void add_run(Program& program);
// The same in the program beside this one that shows scenes in a headset.
using RunInHeadset = int (*)(const scenario::Scenario& scenario, const RunOptions& options,
                             Participation* participation);
void add_run_in_headset(Program& program, RunInHeadset run);
void add_replay(Program& program);
void add_results(Program& program);
void add_check(Program& program);
void add_explain(Program& program);
void add_devices(Program& program);
void add_device_test(Program& program);
void add_calibrate(Program& program);
void add_doctor(Program& program);
void add_strip(Program& program);
void add_schema(Program& program);
void add_import(Program& program);
void add_new(Program& program);
void add_path(Program& program);
void add_edit(Program& program);
void add_studies(Program& program);

}  // namespace fulcrum::app
