#pragma once
// The panel of the settings over the start page: while it is open, keys and presses are its own, and what is
// changed is seen at once and remembered.

#include <optional>

#include "engine/app/settings/settings_menu.h"
#include "engine/app/window/window_stage.h"

namespace fulcrum::app {

class SettingsPanel {
public:
  explicit SettingsPanel(WindowStage& stage) : stage_(stage) {}

  void open() { menu_.emplace(stage_.settings()); }
  bool is_open() const { return menu_.has_value(); }

  // While it is open.
  void press(StartMenu::Key key) { follow(menu_->press(key)); }
  // x, y: fractions of the picture's height, from its top left.
  void press_at(double x, double y);
  ui::SettingsPage page() const { return menu_->page(); }

private:
  void follow(SettingsMenu::Wish wish);

  WindowStage& stage_;
  std::optional<SettingsMenu> menu_;
};

}  // namespace fulcrum::app
