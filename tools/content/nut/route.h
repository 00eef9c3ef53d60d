#pragma once
// The way of the nut: over the pipe, down behind it, onto the bolt and down its thread.

#include <string>
#include <vector>

#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

std::vector<RoutePose> make_route();

// The same way, but with the nut tilted one way and the other once it is on the thread, which holds it.
std::vector<RoutePose> make_tilted_route();

// The scenario's list of checkpoints, as YAML.
std::string places_yaml();

}  // namespace fulcrum::content
