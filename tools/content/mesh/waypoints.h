#pragma once
// The way of an expert hand, and how scenarios write it.

#include <optional>
#include <string>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

struct RoutePose {
  std::string note;               // empty: as before
  Eigen::Isometry3d X_WT;         // of the tool's model, m
  double travel = 0.0;            // s, from the pose before
  double dwell = 0.0;             // s
  bool presses = false;           // it aims a little into what it touches
  std::optional<double> hold{};   // m, where along the tool the hand holds it; none: as before
  std::optional<double> press{};  // N, how firmly; none: as before
  std::optional<double> stop{};   // s, of the dwell, for which the hand stops the force; none: it does not
};

// The expert's file as YAML. `how`: what someone who knows how does; `program` is named as its author.
std::string route_yaml(const std::string& how, const std::string& program,
                       const std::vector<RoutePose>& route);
// Any hand's. `what`: a sentence; `command` is named as the file's author.
std::string waypoints_yaml(const std::string& what, const std::string& command,
                           const std::vector<RoutePose>& route);

// A line of a scenario's list of checkpoints; position and radius in m. mirrored_name: where the scene is
// mirrored; empty: the same.
std::string checkpoint_yaml(const std::string& name, const Eigen::Vector3d& p_W, double radius,
                            const std::string& mirrored_name = {});

}  // namespace fulcrum::content
