#pragma once
// The taps of someone who knows how.

#include <string>
#include <vector>

#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

// Straight onto a face, and off it again.
struct Tap {
  std::string name;          // of its checkpoint
  Eigen::Vector3d p_W;       // m, on the face
  Eigen::Vector3d nhat_W;    // unit, of the face
  Eigen::Vector3d stylus_W;  // unit, from the tip along the rod
};

std::vector<Tap> make_taps();

// `press` (m): how far beyond the face the hand aims.
std::vector<RoutePose> make_route(const std::vector<Tap>& taps, double press);

// The scenario's list of checkpoints, as YAML.
std::string taps_yaml(const std::vector<Tap>& taps);

}  // namespace fulcrum::content
