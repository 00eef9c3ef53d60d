#pragma once
// The tool: a slim rod with a round tip, and a band where it is held.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double stylus_tip_radius = 2.0 * mm;

// Its frame: the centre of the tip's hemisphere at the origin, the rod towards +z, the band at z = 120 mm.
Model make_stylus();

}  // namespace fulcrum::content
