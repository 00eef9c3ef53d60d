#pragma once

#include "tools/content/piping/plant.h"

namespace fulcrum::content {

// A pressure gauge on a pipe: X_WG has its origin on the pipe's axis, z_G up the stem and x_G where the dial
// looks.
void add_gauge(Plant* plant, const std::string& name, const Eigen::Isometry3d& X_WG, double pipe_radius);

}  // namespace fulcrum::content
