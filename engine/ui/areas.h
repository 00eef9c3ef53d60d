#pragma once
// What the panels leave free of the picture.

#include <span>
#include <vector>

#include "engine/ui/canvas.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::ui {

// Of all panels that are always to be read; a second view is put where these leave room.
std::vector<Area> fixed_areas(const Canvas& canvas, const OverlayState& state);
// With the second view.
std::vector<Area> panel_areas(const Canvas& canvas, const OverlayState& state);

// Whether it is inside the picture's margin and touches none of them.
bool is_clear(const Canvas& canvas, const Area& area, std::span<const Area> taken);

// An area of that size beside a round thing: to the right, left, above or below it, as near as is clear.
// Where nothing is: without a size.
Area clear_beside(const Canvas& canvas, ImVec2 middle, float radius, ImVec2 size,
                  std::span<const Area> taken);

}  // namespace fulcrum::ui
