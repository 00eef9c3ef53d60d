#pragma once
// The tool: a dental explorer with one working end, a shepherd's hook.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double explorer_tip_radius = 0.25 * mm;

// Its frame: the tip's centre at the origin, the tip pointing along -y, the handle towards +z and up.
Model make_explorer();

}  // namespace fulcrum::content
