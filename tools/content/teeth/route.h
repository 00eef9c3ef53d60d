#pragma once
// Where the trainee has to take the explorer's tip, and a way there that touches nothing before it should.

#include <string>
#include <vector>

#include "tools/content/mesh/triangle_tree.h"
#include "tools/content/mesh/waypoints.h"
#include "tools/content/teeth/dentition.h"

namespace fulcrum::content {

// A checkpoint: the tip rests there, let down from above until it nearly touches.
struct Stop {
  std::string name;
  Eigen::Vector3d tip_W;  // m
  double yaw = 0.0;       // rad, of the handle about y: 0 points it at the viewer, positive to the jaw's left
};

// `scene` holds the jaw's triangles, in metres.
std::vector<Stop> make_stops(const Dentition& dentition, const TriangleTree& scene);

std::vector<RoutePose> make_route(const std::vector<Stop>& stops);

// The scenario's list of checkpoints, as YAML.
std::string stops_yaml(const std::vector<Stop>& stops);

}  // namespace fulcrum::content
