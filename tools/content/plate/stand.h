#pragma once
// The plates, what holds them, and what that stands on. Frame W: the middle of the level face, y up, z to the
// trainee.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double bench_height = -200.0 * mm;  // y of its top

Model make_plates();
Model make_stand();
Model make_bench();

}  // namespace fulcrum::content
