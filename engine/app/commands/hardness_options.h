#pragma once

#include <optional>
#include <string>

#include "engine/app/cli/run_options.h"

namespace fulcrum::app {

// The command line of `fulcrum hardness`. Of `run` count out, force and json.
struct HardnessOptions {
  RunOptions run;
  std::string device = "w6d";
  double speed = 0.15;                // m/s
  std::optional<double> motor_limit;  // N m, of every motor of an arm
};

}  // namespace fulcrum::app
