#include "engine/ui/panels.h"

#include "engine/ui/areas.h"
#include "engine/ui/columns.h"

namespace fulcrum::ui {

void draw_overlay(const Canvas& canvas, const OverlayState& state, const Peaks& peaks) {
  if (state.busy) return draw_busy(canvas, *state.busy);
  if (state.settings) return draw_settings(canvas, *state.settings);
  if (state.start) return draw_start(canvas, *state.start);
  const bool has_card = state.keys_visible || state.debrief;
  if (!has_card) draw_touches(canvas, state);
  draw_second_view(canvas, state);
  draw_handles(canvas, state);
  if (!has_card) draw_way(canvas, state);
  draw_dials(canvas, state, peaks);
  draw_checkpoints(canvas, state);
  draw_health(canvas, state);
  draw_trouble(canvas, state);
  draw_cues(canvas, state);
  draw_holding(canvas, state);
  draw_motors(canvas, state);
  draw_message(canvas, state);
  if (!has_card) draw_target(canvas, state);
  draw_timeline(canvas, state);
  if (!state.keys_visible) draw_debrief(canvas, state);
  draw_keys(canvas, state);
  draw_banner(canvas, state);  // last: nothing hides it
}

}  // namespace fulcrum::ui
