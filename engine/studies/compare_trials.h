#pragma once
// The trials of a comparison, run offline, as many at a time as the machine has cores.

#include <functional>

#include "engine/analysis/compare/compare.h"
#include "engine/app/prepare/prepare.h"
#include "engine/studies/compare_options.h"

namespace fulcrum::app {

// Trial i of every variant has the scenario's seed + i. A trial ends where its task is completed, at the
// scenario's time limit, at a fault, or where a recorded motion ends. Only what nothing_to_compare() lets
// through can be run. The command is the caller's to add.
analysis::compare::Comparison run_trials(const Prepared& prepared, const CompareOptions& options,
                                         const std::function<void(double)>& progress);

// A sentence where there is no torque substitution, no such hand, or a tape that cannot be read.
std::optional<Error> nothing_to_compare(const Prepared& prepared, const CompareOptions& options);

}  // namespace fulcrum::app
