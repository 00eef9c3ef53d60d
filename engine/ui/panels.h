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
ImU32 load_colour(const Palette& colours, float fraction);

// Theme units. 0: there is no such panel. hints: with the line of keys and view; slim: without the bars.
float health_height(const OverlayState& state, bool hints);
float cues_height(const OverlayState& state, bool slim);
float holding_height(const OverlayState& state);
float motors_height(const OverlayState& state);
float checkpoints_height(const OverlayState& state, std::size_t rows);
// Of as many dials as that room has width for; the force comes first.
float dials_width(const OverlayState& state, float room);
float dials_height(bool slim);
// In a picture of that height; with as many plots as leave the scene its room.
float timeline_panel_height(const OverlayState& state, float height, bool slim);

// Where those are whose size follows from their words; without a size: nowhere.
Area checkpoints_area(const Canvas& canvas, const OverlayState& state);
Area trouble_area(const Canvas& canvas, const OverlayState& state);
Area message_area(const Canvas& canvas, const OverlayState& state);
Area returning_area(const Canvas& canvas, const OverlayState& state);
Area debrief_area(const Canvas& canvas, const OverlayState& state);
Area keys_area(const Canvas& canvas, const OverlayState& state);

// Of the list of keys; 0: it is not visible.
std::size_t keys_pages(const Canvas& canvas, const OverlayState& state);

// All that the state asks for.
void draw_overlay(const Canvas& canvas, const OverlayState& state, const Peaks& peaks);
Area second_view_area(const Canvas& canvas, const OverlayState& state);

void draw_way(const Canvas& canvas, const OverlayState& state);                        // in the scene
void draw_dials(const Canvas& canvas, const OverlayState& state, const Peaks& peaks);  // bottom left
void draw_checkpoints(const Canvas& canvas, const OverlayState& state);                // top left
void draw_health(const Canvas& canvas, const OverlayState& state);                     // top right
void draw_trouble(const Canvas& canvas, const OverlayState& state);                    // beside it
void draw_cues(const Canvas& canvas, const OverlayState& state);                       // below it
void draw_holding(const Canvas& canvas, const OverlayState& state);                    // below that
void draw_motors(const Canvas& canvas, const OverlayState& state);                     // bottom right
void draw_message(const Canvas& canvas, const OverlayState& state);                    // bottom middle
void draw_target(const Canvas& canvas, const OverlayState& state);       // in the scene, clear of all these
void draw_timeline(const Canvas& canvas, const OverlayState& state);     // bottom, after the end
void draw_touches(const Canvas& canvas, const OverlayState& state);      // in the scene
void draw_handles(const Canvas& canvas, const OverlayState& state);      // in the scene
void draw_second_view(const Canvas& canvas, const OverlayState& state);  // its frame and name
void draw_debrief(const Canvas& canvas, const OverlayState& state);      // middle, after the end
void draw_keys(const Canvas& canvas, const OverlayState& state);         // middle, when visible
void draw_banner(const Canvas& canvas, const OverlayState& state);       // across, when force is off
void draw_busy(const Canvas& canvas, const Busy& busy);                  // middle, alone
void draw_start(const Canvas& canvas, const StartPage& page);            // all over, alone
void draw_settings(const Canvas& canvas, const SettingsPage& page);      // middle, alone
void draw_device_panel(const Canvas& canvas, const DevicePanel& panel);  // middle, over the start page

}  // namespace fulcrum::ui
