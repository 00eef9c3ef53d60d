#pragma once
// The panel of the settings over the start page: while it is open, keys and presses are its own, and what is
// changed is seen at once and remembered.

#include <optional>
#include <string>

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
  // Its note is why what was changed is not remembered, where it is not.
  ui::SettingsPage page() const;

private:
  void follow(SettingsMenu::Wish wish);

  WindowStage& stage_;
  std::optional<SettingsMenu> menu_;
  std::string not_kept_;  // why the newest change is not remembered; empty: it is
};

}  // namespace fulcrum::app
