#pragma once
// What the finger sweeps over: a glass tablet, with the window in which it is slowed down marked on it.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double window_half = 10.0 * mm;  // of the window, about x = 0
inline constexpr double turn_at = 64.0 * mm;      // where the target turns, to either side
inline constexpr double target_z = -24.0 * mm;    // beyond the fingertip

// The middle of the window, on the glass, is the origin of W.
Model make_tablet();
Model make_window_marks();  // to be seen only
Model make_desk();          // to be seen only

}  // namespace fulcrum::content
