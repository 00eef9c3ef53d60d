#pragma once
// Where everything is. Frame P is the panel's: the middle of its face, x to the right, y up along it, z out
// of it towards the trainee. It leans back, so that who sits before it looks straight at it. The origin of W
// is P's, y up, z to the trainee.

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

inline constexpr double panel_lean = 20.0 * degree;
inline const Eigen::Vector3d panel_half(180.0 * mm, 115.0 * mm, 8.0 * mm);
inline constexpr double bench_height = -135.0 * mm;  // y of its top, in W

Eigen::Isometry3d panel_in_world();  // X_WP

// The five stations, in P.
inline const Eigen::Vector3d hoop_middle(-95.0 * mm, 48.0 * mm, 60.0 * mm);
inline constexpr double hoop_radius = 34.0 * mm;

inline const Eigen::Vector3d slot_middle(72.0 * mm, 58.0 * mm, 0.0);
inline constexpr double slot_depth = 32.0 * mm;  // of the box that has it, and is closed by the panel
inline constexpr double slot_half_width = 36.0 * mm, slot_half_height = 12.0 * mm;

inline const Eigen::Vector3d pad_middle(-95.0 * mm, -58.0 * mm, 0.0);
inline constexpr double pad_height = 20.0 * mm;

inline const Eigen::Vector3d ridges_middle(12.0 * mm, -48.0 * mm, 0.0);
inline constexpr double ridges_half_width = 26.0 * mm;
inline constexpr double ridge_pitch = 14.0 * mm, ridge_height = 3.2 * mm;
inline constexpr int ridge_count = 6;
inline constexpr double ridges_base = 6.0 * mm;  // from the panel to the bottom between two of them

inline const Eigen::Vector3d button_middle(112.0 * mm, -52.0 * mm, 0.0);
inline constexpr double button_height = 42.0 * mm;

}  // namespace fulcrum::content
