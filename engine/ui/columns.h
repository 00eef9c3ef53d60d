#pragma once
// Where the panels at the edges of the picture are, in theme units: the same for drawing and for the pointer.
// In a picture that has no room for all of them some are slimmer, then the less important are left out, so
// that none lies over another. From the least important: motors, switches of cues, the holding point, the
// list of checkpoints, force and torque, the device.

#include "engine/ui/canvas.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::ui {

constexpr float kPanelGap = 10.0F;
constexpr float kColumn = 214.0F;  // width of the panels at the right

// Without a size: it is not there.
struct Columns {
  Area health, cues, holding, motors;  // from the top right to the bottom right
  Area dials, timeline;                // at the bottom, from the left
  Area band;                           // across, while the force is off
  bool hints = true;                   // in the panel of the device
  bool slim_cues = false;              // switches without bars
  bool slim_dials = false;             // bars in place of arcs
  bool slim_timeline = false;          // without a caption
};

Columns columns_of(const OverlayState& state, float width, float height);
// The same, without those that a card in the middle would cover.
Columns columns_of(const Canvas& canvas, const OverlayState& state);

// The area, or nothing where such a card, or the band of a stop, would cover a part of it.
Area unless_covered(const Canvas& canvas, const OverlayState& state, const Area& area);

// Less air in a low picture.
constexpr float margin_of(float height) {
  return height < 460.0F ? 10.0F : 18.0F;
}

bool touch(const Area& a, const Area& b);

}  // namespace fulcrum::ui
