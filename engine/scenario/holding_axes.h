#pragma once
// Where the hand holds a stick, drawn as three axes: "Compensating device inertia for 6-DOF haptic rendering"
// shows its control point so.

#include <cstdint>

#include "engine/render/visual_desc.h"

namespace fulcrum::scenario {

// Arrows along x (red), y (green) and z (blue) from the origin, which follow kFollowsHoldingPoint. The one
// along x has no shaft of its own: the stick is it, between a collar where the hand is and the arrow's head.
void add_holding_axes(render::VisualDesc& desc, std::uint32_t layers);

}  // namespace fulcrum::scenario
