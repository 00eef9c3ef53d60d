#include "engine/app/settings/settings_menu.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>

#include "engine/app/start/ring.h"

namespace fulcrum::app {
namespace {

constexpr std::array<const char*, render::kQualityLevels.size() + 1> kPictureWords = {
    "automatic", "best", "high", "medium", "low", "lowest"};

// The value `by` places on from that one, in a ring.
float next_of(std::span<const float> values, float from, int by) {
  const auto now = std::ranges::find(values, from);
  const auto at = now == values.end() ? 0 : static_cast<std::size_t>(now - values.begin());
  return values[turned(at, by, values.size())];
}

std::string in_percent(double fraction) {
  char words[16];
  std::snprintf(words, sizeof words, "%.0f %%", 100.0 * fraction);
  return words;
}

}  // namespace

SettingsMenu::Wish SettingsMenu::change(std::size_t row, int by) {
  if (row == text) settings_.look.text = next_of(kTextSizes, settings_.look.text, by);
  if (row == palette)
    settings_.look.palette = settings_.look.palette == ui::PaletteName::standard
                                 ? ui::PaletteName::colour_blind
                                 : ui::PaletteName::standard;
  if (row == picture) {
    const std::size_t at = turned(settings_.picture ? *settings_.picture + 1 : 0, by, kPictureWords.size());
    settings_.picture = at > 0 ? std::optional(at - 1) : std::nullopt;
  }
  if (row == volume) settings_.volume = next_of(kVolumes, settings_.volume, by);
  return Wish::changed;
}

SettingsMenu::Wish SettingsMenu::press(StartMenu::Key key) {
  using Key = StartMenu::Key;
  switch (key) {
    case Key::up:
    case Key::down:
      focus_ = turned(focus_, key == Key::up ? -1 : 1, rows + 1);
      return Wish::none;
    case Key::left:
    case Key::right:
      return focus_ < rows ? change(focus_, key == Key::left ? -1 : 1) : Wish::none;
    case Key::accept:
      return focus_ < rows ? change(focus_, 1) : Wish::back;
    case Key::back:
      return Wish::back;
    case Key::erase:
      return Wish::none;
  }
  return Wish::none;
}

SettingsMenu::Wish SettingsMenu::click(const ui::SettingsHit& hit) {
  focus_ = std::min<std::size_t>(hit.row, rows);
  if (focus_ == rows) return Wish::back;
  return change(focus_, hit.side == 0 ? 1 : hit.side);
}

ui::SettingsPage SettingsMenu::page() const {
  const bool safe = settings_.look.palette == ui::PaletteName::colour_blind;
  ui::SettingsPage page;
  page.rows = {
      {"Text size", in_percent(static_cast<double>(settings_.look.text))},
      {"Colours", safe ? "for colour blindness" : "standard"},
      {"Picture", kPictureWords[settings_.picture ? *settings_.picture + 1 : 0]},
      {"Sound", settings_.volume > 0.0F ? in_percent(static_cast<double>(settings_.volume)) : "off"}};
  page.focus = focus_;
  constexpr std::array<const char*, rows + 1> notes = {
      "All text, gauges and buttons.",
      "Blue against yellow and orange, for eyes that do not tell red from green.",
      "Shadows and sharpness of the scene; automatic: as good as thirty pictures a second allow.",
      "Of scenes that are heard; F4 mutes one while it runs.",
      "",
  };
  page.note = notes[focus_];
  page.help = "Arrows choose and change, Esc goes back";
  return page;
}

}  // namespace fulcrum::app
