#pragma once
// The panels of the overlay, each at its own edge of the picture.

#include "engine/ui/canvas.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::ui {

// Peaks to mark on the dials.
struct Peaks {
  double force_N = 0.0;
  double torque_Nm = 0.0;
};

// Calm, serious, at the limit: of what is driven by this fraction of it.
ImU32 load_colour(float fraction);

// Theme units, of the panel at the top right.
float health_height(const OverlayState& state);
// Theme units, of the panel below it; 0: there is none.
float cues_height(const OverlayState& state);
// Theme units from the top of the picture to the lower edge of the panel below that; 0: there is none.
float holding_bottom(const OverlayState& state);

// Theme units, of the panels at the bottom left and right; 0: there are none.
float dials_width(const OverlayState& state);
float motors_width();
// Theme units that the timeline takes from the bottom of the picture; 0: there is none.
float timeline_height(const OverlayState& state);

// Where they are; without a size: nowhere.
Area checkpoints_area(const OverlayState& state);
Area health_area(const Canvas& canvas, const OverlayState& state);
Area trouble_area(const Canvas& canvas, const OverlayState& state);
Area cues_area(const Canvas& canvas, const OverlayState& state);
Area holding_area(const Canvas& canvas, const OverlayState& state);
Area motors_area(const Canvas& canvas, const OverlayState& state);
Area dials_area(const Canvas& canvas, const OverlayState& state);
Area message_area(const Canvas& canvas, const OverlayState& state);

void draw_way(const Canvas& canvas, const OverlayState& state);                        // in the scene
void draw_dials(const Canvas& canvas, const OverlayState& state, const Peaks& peaks);  // bottom left
void draw_checkpoints(const Canvas& canvas, const OverlayState& state);                // top left
void draw_health(const Canvas& canvas, const OverlayState& state);                     // top right
void draw_trouble(const Canvas& canvas, const OverlayState& state);                    // beside it
void draw_cues(const Canvas& canvas, const OverlayState& state);                       // below it
void draw_holding(const Canvas& canvas, const OverlayState& state);                    // below that
void draw_motors(const Canvas& canvas, const OverlayState& state);    // bottom right, where there is room
void draw_message(const Canvas& canvas, const OverlayState& state);   // bottom middle
void draw_target(const Canvas& canvas, const OverlayState& state);    // in the scene, clear of all these
void draw_timeline(const Canvas& canvas, const OverlayState& state);  // bottom middle, after the end
void draw_debrief(const Canvas& canvas, const OverlayState& state);   // middle, after the end
void draw_keys(const Canvas& canvas, const OverlayState& state);      // middle, when visible
void draw_banner(const Canvas& canvas, const OverlayState& state);    // across, when force is off
void draw_busy(const Canvas& canvas, const Busy& busy);               // middle, alone
void draw_start(const Canvas& canvas, const StartPage& page);         // all over, alone

}  // namespace fulcrum::ui
