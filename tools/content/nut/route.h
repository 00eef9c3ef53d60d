#pragma once
// The way of the nut: over the pipe, down behind it, onto the bolt and down its thread.

#include <string>
#include <vector>

#include "tools/content/mesh/solid.h"
#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

// m: how far beyond where the thread has the nut a hand goes that presses it on lightly. Then the nut takes
// the first groove that opens to it. Without that a handle whose encoder counts in steps of 28 um may have it
// run onto the crest where the thread begins, and take the groove a turn later.
inline constexpr double light_press = 0.3 * mm;

std::vector<RoutePose> make_route(double press);

// The same way, but with the nut tilted one way and the other once it is on the thread, which holds it.
std::vector<RoutePose> make_tilted_route(double press);

// The scenario's list of checkpoints, as YAML.
std::string places_yaml();

}  // namespace fulcrum::content
