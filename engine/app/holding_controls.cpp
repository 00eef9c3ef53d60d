#include "engine/app/holding_controls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace fulcrum::app {
namespace {

using Part = ui::HoldingPress::Part;

constexpr double kKeyStep = 5e-3;  // m, that a key moves the holding point by

std::string at_mm(const char* words, double place) {
  char text[64];
  std::snprintf(text, sizeof text, "%s %.0f mm", words, 1e3 * place);
  return text;
}

std::string sensed_words(const SceneDesc& scene, const HoldingCues& cues) {
  switch (cues.state) {
    case HoldingState::set:
      return scene.device.strip ? "the strip is not listened to" : "told: the device has no strip";
    case HoldingState::measured:
      return at_mm("the strip feels it at", cues.place);
    case HoldingState::kept:
      return at_mm("lost: still taken to be at", cues.place);
    case HoldingState::fading:
      return at_mm("lost: let go to what was told:", cues.place);
    case HoldingState::lost:
      return at_mm("lost: taken to be at", cues.place);
  }
  return {};
}

// The level `by` steps from the one in force.
double level_beside(const ui::HoldingPanel& shown, int by) {
  const auto nearest = std::ranges::min_element(
      shown.levels, {}, [&](double level) { return std::abs(level - shown.stiffness); });
  const auto last = static_cast<std::ptrdiff_t>(shown.levels.size()) - 1;
  return shown.levels[static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(nearest - shown.levels.begin() + by, 0, last))];
}

}  // namespace

std::optional<ui::HoldingPanel> holding_panel(const SceneDesc& scene, const TickRecord& record) {
  if (!scene.holding_point || !record.holding) return std::nullopt;
  const HoldingCues& cues = *record.holding;
  ui::HoldingPanel panel;
  panel.place = cues.place;
  panel.low = scene.holding_point->low;
  panel.high = scene.holding_point->high;
  panel.measured = cues.state != HoldingState::set;
  panel.sensed = sensed_words(scene, cues);
  panel.sensed_well = cues.state == HoldingState::set || cues.state == HoldingState::measured;
  panel.stiffness = record.contact_stiffness.value_or(scene.contact.stiffness);
  panel.levels = scene.contact.levels;
  panel.limit = cues.limit;
  if (!record.inertia) return panel;
  if (scene.inertia_compensation->switchable)
    panel.methods = {"none", "arm", "acceleration"};
  else
    panel.methods = {"as the scene has it"};
  panel.method =
      scene.inertia_compensation->switchable ? static_cast<std::size_t>(record.inertia->method) : 0;
  panel.faded = record.inertia->faded;
  return panel;
}

std::vector<Command> holding_commands(const ui::HoldingPanel& shown, const ui::HoldingPress& press) {
  using Kind = Command::Kind;
  switch (press.part) {
    case Part::place:  // what a person says is not overruled by the strip
      if (shown.measured) return {{Kind::hold_measured, 0}, {Kind::hold_at, press.value}};
      return {{Kind::hold_at, press.value}};
    case Part::measured:
      return {{Kind::hold_measured, press.value}};
    case Part::stiffness:
      return {{Kind::contact_stiffness, press.value}};
    case Part::method:
      if (shown.methods.size() < 2) return {};
      return {{Kind::compensation, press.value}};
  }
  return {};
}

std::vector<Command> holding_commands(const ui::HoldingPanel& shown, HoldingKey key) {
  switch (key) {
    case HoldingKey::nearer:
    case HoldingKey::farther: {
      const double step = key == HoldingKey::nearer ? -kKeyStep : kKeyStep;
      return holding_commands(shown, {Part::place, std::clamp(shown.place + step, shown.low, shown.high)});
    }
    case HoldingKey::softer:
    case HoldingKey::stiffer:
      if (shown.levels.empty()) return {};
      return holding_commands(shown,
                              {Part::stiffness, level_beside(shown, key == HoldingKey::softer ? -1 : 1)});
    case HoldingKey::method:
      if (shown.methods.empty()) return {};
      return holding_commands(shown,
                              {Part::method, static_cast<double>((shown.method + 1) % shown.methods.size())});
    case HoldingKey::measured:
      return holding_commands(shown, {Part::measured, shown.measured ? 0.0 : 1.0});
  }
  return {};
}

std::vector<ui::KeyLine> holding_keys() {
  return {{"[ ]", "move the holding point"},
          {"- =", "softer or stiffer"},
          {"N", "next method against inertia"},
          {"H", "measure the holding point or not"}};
}

}  // namespace fulcrum::app
