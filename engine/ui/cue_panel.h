#pragma once
// Where the panel of the cues lies, and what a press on it means: the same figures draw it and read the
// mouse.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::ui {

// Pixels of a theme unit in a picture of that height (pixels); text: as in Look.
float overlay_scale(std::uint32_t height, float text = 1.0F);

struct PanelPoint {
  float width = 0.0F, height = 0.0F;  // theme units, of the picture
  float x = 0.0F, y = 0.0F;           // theme units, from the top left of the picture
};

// (x, y) in fractions of the picture's height, from its top left.
PanelPoint panel_point(render::Extent picture, const Look& look, double x, double y);

struct CuePress {
  std::size_t cue = 0;  // index into OverlayState::cues
  double gain = 0.0;    // 0..1, what the press sets it to
};

// A press on a switch turns the cue off, or on at `gains` of it; on the bar below it, it sets the gain.
// Elsewhere: nothing.
std::optional<CuePress> pressed_cue(const OverlayState& state, const std::vector<double>& gains,
                                    const PanelPoint& press);

}  // namespace fulcrum::ui
