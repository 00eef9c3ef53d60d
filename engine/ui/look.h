#pragma once
// How the overlay looks to a person, who chooses it on the start page (docs/settings.md).

#include "engine/render/frame_state.h"

namespace fulcrum::ui {

enum class PaletteName { standard, colour_blind };

struct Look {
  PaletteName palette = PaletteName::standard;
  float text = 1.0F;  // all of the overlay is larger by this
};

// Of the checkpoints in the scene.
const render::MarkerColours& marker_colours(const Look& look);

}  // namespace fulcrum::ui
