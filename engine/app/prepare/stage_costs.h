#pragma once
// CPU time of each part of the tick, measured on a stretch of the scenario's own motion.

#include <map>
#include <string>

#include "engine/app/prepare/prepare.h"

namespace fulcrum::app {

// us per tick for the parts of World::parts() that have a cost of their own, and "tick" for the whole.
Result<std::map<std::string, double>> measure_stages(const Prepared& prepared, const std::string& hand);

}  // namespace fulcrum::app
