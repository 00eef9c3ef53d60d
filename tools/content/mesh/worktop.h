#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The bench under a scene, as a model of its own: to be seen, not touched. `top_W` (m): the middle of its
// upper face.
Model make_worktop(const Eigen::Vector3d& top_W);

}  // namespace fulcrum::content
