#pragma once
// What a person does in the panel of the settings, as plain state: keys and presses go in, the page and the
// settings come out.

#include "engine/app/settings/settings.h"
#include "engine/app/start/start_menu.h"
#include "engine/ui/settings_page.h"

namespace fulcrum::app {

class SettingsMenu {
public:
  explicit SettingsMenu(const Settings& settings) : settings_(settings) {}

  enum class Wish { none, changed, back };

  Wish press(StartMenu::Key key);
  Wish click(const ui::SettingsHit& hit);

  const Settings& settings() const { return settings_; }
  ui::SettingsPage page() const;

private:
  enum Row : std::size_t { text, palette, picture, volume, rows };  // rows: how many there are

  Wish change(std::size_t row, int by);

  Settings settings_;
  std::size_t focus_ = 0;  // of the rows; rows: the button
};

}  // namespace fulcrum::app
