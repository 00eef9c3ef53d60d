#pragma once
// The plates and what holds them. Frame W: the middle of the level face, y up, z to the
// trainee.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double frame_half_depth = 26.0 * mm;  // along z
inline constexpr double frame_bar = 17.0 * mm;         // how wide its bars are
inline constexpr double bench_height = -200.0 * mm;    // y of its top

Model make_plates();
Model make_stand();

}  // namespace fulcrum::content
