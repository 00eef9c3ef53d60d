#pragma once
// The tool: a flat blade with a round end, as of a spatula, in a handle.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double blade_half_width = 20.0 * mm;
inline constexpr double blade_half_thickness = 4.0 * mm;

// Its frame: the tip at the origin, the handle towards +z, the blade's width along x.
Model make_blade();

}  // namespace fulcrum::content
