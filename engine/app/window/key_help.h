#pragma once
// What F1 lists of the keys.

#include <span>
#include <string>
#include <vector>

#include "engine/scenario/scenario.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::app {

// As a person reads it: "down the canal" of down_the_canal.
std::string view_name(const scenario::View& view);

// state: the panels that are there. circle: of confusion, is there. has_start_page: F10 goes back to it.
std::vector<ui::KeyLine> key_lines(const ui::OverlayState& state, std::span<const scenario::View> views,
                                   bool circle, bool has_start_page);

}  // namespace fulcrum::app
