#pragma once
// The panel of the holding point, and what a press on it means: the same figures draw it and read the mouse.

#include <optional>

#include "engine/ui/cue_panel.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::ui {

struct HoldingPress {
  enum class Part { place, measured, stiffness, method };
  Part part = Part::place;
  double value = 0.0;  // m; 0 or 1; N/m; an index into HoldingPanel::methods
};

// A press elsewhere is nothing.
std::optional<HoldingPress> pressed_holding(const OverlayState& state, const PanelPoint& press);

// m: where a slider that is held is drawn to, by x alone.
double dragged_place(const OverlayState& state, const PanelPoint& pointer);

}  // namespace fulcrum::ui
