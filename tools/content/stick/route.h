#pragma once
// The touches of someone who knows how.

#include <string>
#include <vector>

#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

// `depth` (m): how far beyond the ball's top the hand aims.
std::vector<RoutePose> make_route(double depth);

// The scenario's list of checkpoints, as YAML. What has to reach them is the middle of the stick.
std::string touches_yaml();

}  // namespace fulcrum::content
