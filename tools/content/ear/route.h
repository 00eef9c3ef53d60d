#pragma once
// The expert's way along the canal: where the needle has the most room, rolling between the bends.

#include <string>
#include <vector>

#include "tools/content/ear/passage.h"
#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

// Empty if there is none.
std::vector<RoutePose> make_route(const Passage& passage);

// The scenario's list of checkpoints, as YAML.
std::string stops_yaml(const Passage& passage);

}  // namespace fulcrum::content
