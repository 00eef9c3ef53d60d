#include "engine/app/start/settings_panel.h"

#include "engine/app/cli/terminal.h"

namespace fulcrum::app {

void SettingsPanel::press_at(double x, double y) {
  const auto hit = ui::settings_hit(page(), stage_.window().pixels(), stage_.settings().look, x, y);
  if (hit) follow(menu_->click(*hit));
}

void SettingsPanel::follow(SettingsMenu::Wish wish) {
  if (wish == SettingsMenu::Wish::back) menu_.reset();
  if (wish != SettingsMenu::Wish::changed) return;
  stage_.set_settings(menu_->settings());
  const std::optional<Error> failure = write_settings(menu_->settings());
  not_kept_ = failure ? failure->sentence : std::string();
  if (failure) complain("the settings hold until Fulcrum ends. " + not_kept_);
}

ui::SettingsPage SettingsPanel::page() const {
  ui::SettingsPage page = menu_->page();
  if (!not_kept_.empty()) page.note = "This holds until Fulcrum ends. " + not_kept_;
  return page;
}

}  // namespace fulcrum::app
