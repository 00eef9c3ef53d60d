#include "engine/app/start/settings_panel.h"

namespace fulcrum::app {

void SettingsPanel::press_at(double x, double y) {
  const auto hit = ui::settings_hit(menu_->page(), stage_.window().pixels(), stage_.settings().look, x, y);
  if (hit) follow(menu_->click(*hit));
}

void SettingsPanel::follow(SettingsMenu::Wish wish) {
  if (wish == SettingsMenu::Wish::back) menu_.reset();
  if (wish != SettingsMenu::Wish::changed) return;
  stage_.set_settings(menu_->settings());
  write_settings(menu_->settings());
}

}  // namespace fulcrum::app
