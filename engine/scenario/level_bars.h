#pragma once
// How strongly it vibrates at the left and at the right of a fingertip, as bars that stand beside it.

#include <cstdint>

#include "engine/render/visual_desc.h"
#include "haptics/math/linear.h"

namespace fulcrum::scenario {

// Rods with a mark at each quarter, which follow kFollowsLevelFrame: its origin is where the finger touches,
// x to its right, y up. On them bars, 1 m high, which follow kFollowsLeftLevel and kFollowsRightLevel.
void add_level_bars(render::VisualDesc& desc, std::uint32_t layers);

// Of a bar: its foot where the finger touches at p_W (3) m; side: -1 left, 1 right; level: 0 to 1.
glm::mat4 level_pose(const Vec3& p_W, int side, double level);

}  // namespace fulcrum::scenario
