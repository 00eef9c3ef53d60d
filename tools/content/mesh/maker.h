#pragma once
// What the programs make_SCENE have in common: they write models, print the expert's way, and check both.

#include <functional>
#include <string>
#include <vector>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

struct Maker {
  std::string program;                         // "make_SCENE"
  std::function<std::vector<Model>()> models;  // for OUTDIR
  std::function<std::string()> route;          // --route: the expert's file
  std::function<std::string()> checkpoints;    // --checkpoints: the scenario's list
  std::function<bool()> check;                 // --check: prints what it measured; whether all is well
};

// The program's exit code: 0, 1 when something is wrong, 2 with a line of usage.
int run_maker(const Maker& maker, int argc, char** argv);

}  // namespace fulcrum::content
