#pragma once
// What the start page and the settings are made of: rows that are turned by arrows, and buttons.

#include "engine/ui/canvas.h"
#include "engine/ui/start_page.h"

namespace fulcrum::ui {

bool holds(const Area& area, ImVec2 point);

// Of a row, the part that turns it: side -1 at the left of the value, 1 at the right end.
Area arrow_area(const Area& row, int side);
// The side of the row that a press means: -1, 1, or 0 on neither arrow.
int side_of(const Area& row, ImVec2 point);

void draw_menu_row(const Canvas& canvas, const Area& row, const StartPage::Setting& setting, bool focused);
// leads: it goes on, and stands out.
void draw_menu_button(const Canvas& canvas, const Area& area, const std::string& word, bool focused,
                      bool leads);

}  // namespace fulcrum::ui
