#pragma once
// Typefaces for one scale.

#include <string>

#include "engine/ui/canvas.h"

namespace fulcrum::ui {

// Fills the current ImGui atlas anew. `note` gets one line where the typeface is not installed, else
// nothing.
Fonts load_fonts(float scale, std::string& note);

}  // namespace fulcrum::ui
