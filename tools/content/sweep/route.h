#pragma once
// The sweeps of someone who knows how.

#include <string>
#include <vector>

#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

// `press` (m): how far below the glass the hand aims.
std::vector<RoutePose> make_route(double press);

// The scenario's list of checkpoints, as YAML.
std::string sweeps_yaml();

}  // namespace fulcrum::content
