#pragma once

#include <string>

namespace fulcrum::content {

// The way of a hand that turns the spanner wrongly about its long axis while the pipes hold the large ring on
// both sides: the route with those turns, as a path file of the scenario.
std::string wrong_turns_yaml();

}  // namespace fulcrum::content
