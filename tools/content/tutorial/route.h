#pragma once
// The five lessons, as someone goes through them who knows how.

#include <string>
#include <vector>

#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

struct Lesson {
  std::string name;     // of its checkpoint
  Eigen::Vector3d p_P;  // m, where the blade's tip has to be
  double radius = 0.0;  // m
};

std::vector<Lesson> make_lessons();

// Where the blade is at the beginning: X_WM.
Eigen::Isometry3d start_pose();

// press (m): how far into what is touched the hand aims.
std::vector<RoutePose> make_route(double press);

// The scenario's list of checkpoints, as YAML.
std::string lessons_yaml(const std::vector<Lesson>& lessons);

}  // namespace fulcrum::content
