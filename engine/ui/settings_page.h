#pragma once
// The panel of what a person sets for all scenes: rows, and a button back to where they came from.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/look.h"
#include "engine/ui/start_page.h"

namespace fulcrum::ui {

struct SettingsPage {
  std::vector<StartPage::Setting> rows;
  std::size_t focus = 0;  // of the rows; beyond them: the button
  std::string note;       // about the row in focus; empty: none
  std::string help;       // what keys do
};

// What lies under the pointer: a row, or beyond them the button. side: of a row, -1 its left arrow, 1 its
// right one, else 0.
struct SettingsHit {
  std::size_t row = 0;
  int side = 0;
};

// x, y: fractions of the picture's height, from its top left.
std::optional<SettingsHit> settings_hit(const SettingsPage& page, render::Extent picture, const Look& look,
                                        double x, double y);

}  // namespace fulcrum::ui
