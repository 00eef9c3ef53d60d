#pragma once
// The colours that tell states apart: as usual, or such that protanopes, deuteranopes and tritanopes tell
// them apart, too (docs/settings.md). What a colour says, a shape or a word says beside it.

#include <imgui.h>

#include "engine/ui/look.h"

namespace fulcrum::ui {

struct Palette {
  ImU32 accent = 0;               // in use, next, calm
  ImU32 good = 0;                 // reached, in order
  ImU32 warn = 0;                 // under way, near a limit
  ImU32 bad = 0;                  // beyond it, wrong
  ImU32 stop = 0, stop_edge = 0;  // the band that says that the force is off
  ImU32 lead = 0;                 // the button that goes on
  render::MarkerColours markers;  // of the checkpoints in the scene
};

const Palette& palette(PaletteName name);

constexpr ImU32 with_alpha(ImU32 colour, ImU32 alpha) {
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

}  // namespace fulcrum::ui
