#pragma once
// How strongly it vibrates at the left and at the right of a fingertip, as bars that stand beside it.

#include <cstdint>

#include "engine/render/visual_desc.h"
#include "haptics/math/linear.h"
#include "haptics/math/pose.h"

namespace fulcrum::scenario {

// Rods with a mark at each quarter, which follow kFollowsLevelFrame: its origin is where the finger touches,
// x to its right, y up. On them bars, 1 m high, which follow kFollowsLeftLevel and kFollowsRightLevel.
void add_level_bars(render::VisualDesc& desc, std::uint32_t layers);

// How the bars' frame stands: its x along the axis of the sweep, as far as that is level.
Quat level_turn(const Vec3& axis_W);

// Of a bar: its foot, in the bars' frame F; side: -1 left, 1 right; level: 0 to 1.
glm::mat4 level_pose(const Pose& X_WF, int side, double level);

}  // namespace fulcrum::scenario
