#pragma once
// The knocks of someone who knows how: each peg of a station once, then all of the row at once.

#include <string>
#include <vector>

#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

struct Knock {
  std::string name;
  bool counts = false;       // it is a checkpoint
  std::string pegs;          // what the names begin with of the pegs that it meets
  Eigen::Isometry3d X_WT;    // of the bar where it meets the peg
  Eigen::Vector3d motion_W;  // unit, the way it comes
  double run = 0.0;          // m, how far it comes that way
};

std::vector<Knock> make_knocks();

// `press` (m): how far beyond the pegs the hand aims.
std::vector<RoutePose> make_route(const std::vector<Knock>& knocks, double press);

// The scenario's list of checkpoints, as YAML: of the middle of the rod.
std::string knocks_yaml(const std::vector<Knock>& knocks);

}  // namespace fulcrum::content
