#pragma once
// The tool: a needle bent at its end, on a round handle.

#include <vector>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// Its frame: the middle of the tip's round end at the origin, shaft and handle towards +z, the bent end
// pointing from the shaft towards -y.
Model make_needle();

// A ball of the needle.
struct Ball {
  Eigen::Vector3d p_T;  // mm
  double r = 0.0;       // mm
};

// The bent end and the shaft as far as the ear may touch them, as balls in a row.
std::vector<Ball> needle_balls();

// Its centre of mass (3) m, in its frame.
Eigen::Vector3d needle_centre();

}  // namespace fulcrum::content
