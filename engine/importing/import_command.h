#pragma once
// The subcommand of fulcrum-import. A program of its own: who trains need not load what reads other programs'
// files, and a file that a reader fails on ends no other work.

#include "engine/app/cli/program.h"

namespace fulcrum::importing {

void add_import(app::Program& program);

}  // namespace fulcrum::importing
