#pragma once
// `fulcrum workprecision picture`: the renderer's quality levels against path-traced references.

#include <string>

#include "engine/app/cli/run_options.h"

namespace fulcrum::app {

struct PictureStudyOptions {
  RunOptions run;        // out, force, json, gpu
  std::string scene;     // empty: all
  std::string command;   // that asks for this, for a page
  std::string describe;  // a folder: scenes are described there for another renderer, and nothing is drawn
};

// The program's exit code.
int picture_study(const PictureStudyOptions& options);

}  // namespace fulcrum::app
