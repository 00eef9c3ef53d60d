#include "engine/app/start/settings_panel.h"

#include "engine/app/cli/terminal.h"

namespace fulcrum::app {

void SettingsPanel::press_at(double x, double y) {
  const auto hit = ui::settings_hit(menu_->page(), stage_.window().pixels(), stage_.settings().look, x, y);
  if (hit) follow(menu_->click(*hit));
}

void SettingsPanel::follow(SettingsMenu::Wish wish) {
  if (wish == SettingsMenu::Wish::back) menu_.reset();
  if (wish != SettingsMenu::Wish::changed) return;
  stage_.set_settings(menu_->settings());
  if (!write_settings(menu_->settings()))
    complain("the settings hold until Fulcrum ends, since " + settings_file().string() +
             " cannot be written: make it and its folder yours.");
}

}  // namespace fulcrum::app
