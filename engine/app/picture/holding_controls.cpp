#include "engine/app/picture/holding_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace fulcrum::app {
namespace {

using Part = ui::HoldingPress::Part;

constexpr double kKeyStep = 5e-3;  // m, that a key moves the holding point by

std::string at_mm(const char* words, double place) {
  char text[64];
  std::snprintf(text, sizeof text, "%s %.0f mm", words, 1e3 * place);
  return text;
}

std::string sensed_words(const SceneDesc& scene, const HoldingRecord& cues) {
  switch (cues.state) {
    case HoldingState::set:
      return scene.device.strip ? "the strip is not listened to" : "told: the device has no strip";
    case HoldingState::measured:
      return at_mm("the strip feels it at", cues.place);
    case HoldingState::kept:
      return at_mm("lost: still taken to be at", cues.place);
    case HoldingState::fading:
      return at_mm("lost: on its way to the default, at", cues.place);
    case HoldingState::lost:
      return at_mm("lost: taken to be at", cues.place);
  }
  return {};
}

// Those that do something: arm needs a device that renders torque, acceleration a gain.
std::vector<std::string> methods_of(const SceneDesc& scene) {
  std::vector<std::string> methods{"none"};
  if (scene.device.renders_torque) methods.emplace_back("arm");
  if (scene.inertia_compensation->gain > 0) methods.emplace_back("acceleration");
  return methods;
}

// The level `by` steps from the one that was asked for last.
double level_beside(const ui::HoldingPanel& shown, int by) {
  const double asked = shown.pending.value_or(shown.stiffness.value_or(0.0));
  const auto nearest =
      std::ranges::min_element(shown.levels, {}, [&](double level) { return std::abs(level - asked); });
  const auto last = static_cast<std::ptrdiff_t>(shown.levels.size()) - 1;
  return shown.levels[static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(nearest - shown.levels.begin() + by, 0, last))];
}

}  // namespace

std::optional<ui::HoldingPanel> holding_panel(const SceneDesc& scene, const TickRecord& record) {
  if (!scene.holding_point || !record.holding) return std::nullopt;
  const HoldingRecord& cues = *record.holding;
  ui::HoldingPanel panel;
  panel.place = cues.place;
  panel.low = scene.holding_point->low;
  panel.high = scene.holding_point->high;
  panel.measured = cues.state != HoldingState::set;
  panel.sensed = sensed_words(scene, cues);
  panel.sensed_well = cues.state == HoldingState::set || cues.state == HoldingState::measured;
  if (scene.contact.response != ContactResponse::constraint) {
    panel.stiffness = record.contact_stiffness.value_or(scene.contact.stiffness);
    if (record.contact_stiffness_wanted != record.contact_stiffness)
      panel.pending = record.contact_stiffness_wanted;
  }
  panel.levels = scene.contact.levels;
  panel.structure_known = scene.device.structure.has_value();
  panel.limit = cues.limit;
  if (!record.inertia_compensation) return panel;
  const std::vector<std::string> methods = methods_of(scene);
  const auto used = std::ranges::find(methods, name_of(record.inertia_compensation->method));
  const std::size_t method = used == methods.end() ? 0 : static_cast<std::size_t>(used - methods.begin());
  if (scene.inertia_compensation->switchable) {
    panel.methods = methods;
    panel.method = method;
  } else {
    panel.methods = {methods[method]};
  }
  panel.faded = record.inertia_compensation->faded;
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
      return {{Kind::compensation,
               static_cast<double>(std::ranges::find(names_of<InertiaMethod>,
                                                     shown.methods[static_cast<std::size_t>(press.value)]) -
                                   names_of<InertiaMethod>.begin())}};
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
