#pragma once
// What several panels are made of.

#include <string>

#include "engine/ui/canvas.h"

namespace fulcrum::ui {

inline const ImVec2 kSwitch{30.0F, 16.0F};

void draw_switch(const Canvas& canvas, ImVec2 at, bool on);

// A key's cap, its right upper corner at a place. Returns its width.
float draw_key(const Canvas& canvas, ImVec2 right, const std::string& key);

}  // namespace fulcrum::ui
