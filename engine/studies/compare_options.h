#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/app/cli/run_options.h"
#include "haptics/effects/torque_substitution/torque_substitution.h"

namespace fulcrum::app {

// The command line of `fulcrum compare`. Of `run` count scenario, overrides, out, force and json.
struct CompareOptions {
  RunOptions run;
  std::vector<TorqueVariant> variants{TorqueVariant::A, TorqueVariant::B, TorqueVariant::C};
  std::string hand = "yielding";
  std::string tape;  // a recorded motion instead of the hand: one trial
  std::uint64_t trials = 20;
};

// "A,B,C": each at most once. A sentence if that is not it.
std::string read_variants(const std::string& text, std::vector<TorqueVariant>& variants);

}  // namespace fulcrum::app
