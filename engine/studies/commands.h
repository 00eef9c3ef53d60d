#pragma once
// The subcommands of fulcrum-studies. Each adds itself to the program, with its options.

#include "engine/app/cli/program.h"

namespace fulcrum::app {

void add_compare(Program& program);
void add_ambiguity(Program& program);
void add_hardness(Program& program);
void add_stability(Program& program);
void add_workprecision(Program& program);
void add_uniformity(Program& program);

}  // namespace fulcrum::app
