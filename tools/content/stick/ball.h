#pragma once
// What the stick is pushed against: a soft ball in a cup on a stand, and what that stands on.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double ball_radius = 40.0 * mm;
inline constexpr double board_top = -125.0 * mm;  // y
inline constexpr double board_height = 18.0 * mm;

// The top of the ball is the origin of W.
Model make_ball();
Model make_stand();
Model make_table();  // to be seen only

}  // namespace fulcrum::content
