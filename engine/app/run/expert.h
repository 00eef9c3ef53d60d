#pragma once
// What the scenario's own hand makes of its task: the measure of a trial, and what is shown beside it.

#include <functional>
#include <optional>

#include "engine/app/prepare/prepare.h"
#include "engine/app/run/expert_run.h"

namespace fulcrum::app {

// The expert on the scenario's simulated device, offline, in a second or a few; kept in the cache folder
// ($XDG_CACHE_HOME/fulcrum/expert) for this scenario and this program. goes_on: asked a few times a second,
// for how far it is (0 to 1). None: the scenario has no expert, or it was not to go on.
std::optional<ExpertRun> watch_expert(const Prepared& prepared, const std::function<bool(double)>& goes_on);
// The same with a bar in the terminal, until it is interrupted.
std::optional<ExpertRun> watch_expert_in_terminal(const Prepared& prepared);

}  // namespace fulcrum::app
