#pragma once
// The tool: a steel rod in a turned grip.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double bar_radius = 4.0 * mm;
inline constexpr double bar_end = -275.0 * mm;  // z of its free end

// What has to reach a checkpoint: about the middle of the rod, which every knock takes elsewhere.
inline const Eigen::Vector3d bar_middle(0.0, 0.0, -160.0 * mm);

// Its frame: the middle of the grip at the origin, the rod towards -z.
Model make_bar();

}  // namespace fulcrum::content
