#pragma once

#include "tools/content/piping/flanges.h"
#include "tools/content/piping/plant.h"

namespace fulcrum::content {

// A flanged globe valve in a line: z_V along the pipe, x_V along the stem towards the hand-wheel.
// `name` is the line's number.
void add_valve(Plant* plant, const std::string& name, const Eigen::Isometry3d& X_WV, const FlangeSize& size);

}  // namespace fulcrum::content
