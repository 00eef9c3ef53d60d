#pragma once

#include <string>
#include <vector>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The nearest that the spanner comes to some of the plant's parts along the route.
struct Clearance {
  double distance;          // m, from a vertex or the middle of an edge to a triangle
  double route_part;        // of the way from one pose to the next, 0..1
  std::size_t route_index;  // of the pose before
  Eigen::Vector3d p_W;      // m, of the spanner's nearest point
};

// Which parts a clearance is asked for.
enum class Near { slot_pipes, target_bolt, everything_else };

// One Clearance per stretch between two poses of the route.
std::vector<Clearance> clearances(const Model& piping, const Model& spanner, Near near);

// Least distance (m) between parts of different pipe lines, and the two that come so near.
struct LineGap {
  double distance;
  std::string first;
  std::string second;
};

LineGap narrowest_line_gap(const Model& piping);

}  // namespace fulcrum::content
