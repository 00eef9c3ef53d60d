#include "engine/app/cue_switches.h"

#include <algorithm>

#include "engine/app/bridge.h"
#include "engine/ui/cue_panel.h"

namespace fulcrum::app {

namespace {

// What a cue that is off is switched on to.
double gain_of(const SceneDesc& scene, Command::Kind kind) {
  if (kind == Command::Kind::ghost_gain) return scene.torque_substitution->ghost_gain;
  if (kind == Command::Kind::vibration_gain) return scene.torque_substitution->vibration_gain;
  if (kind == Command::Kind::pulse_gain)
    return scene.braking_pulse->gain > 0 ? scene.braking_pulse->gain : 1.0;
  if (kind == Command::Kind::pulse_moment) return 1.0;
  if (kind == Command::Kind::vibrotactile_gain)
    return scene.vibrotactile_motion->gain > 0 ? scene.vibrotactile_motion->gain : 1.0;
  return scene.impact_vibration->gain > 0 ? scene.impact_vibration->gain : 1.0;
}

}  // namespace

CueSwitches::CueSwitches(const SceneDesc& scene) : kinds_(cue_commands(scene)) {
  for (const Command::Kind kind : kinds_) switched_on_.push_back(gain_of(scene, kind));
}

Command CueSwitches::set(std::size_t cue, double gain) {
  if (gain > 0) switched_on_[cue] = gain;
  return {kinds_[cue], gain};
}

std::optional<Command> CueSwitches::toggle(Command::Kind kind, const ui::OverlayState& shown) {
  const auto cue = static_cast<std::size_t>(std::ranges::find(kinds_, kind) - kinds_.begin());
  if (cue >= std::min(kinds_.size(), shown.cues.size())) return std::nullopt;
  return set(cue, shown.cues[cue].gain > 0 ? 0.0 : switched_on_[cue]);
}

std::optional<Command> CueSwitches::press(const ui::OverlayState& shown, render::Extent size, double x,
                                          double y) {
  const ui::PanelPoint at = ui::panel_point(size, x, y);
  const auto press = ui::pressed_cue(shown, switched_on_, at.width, at.x, at.y);
  if (!press) return std::nullopt;
  return set(press->cue, press->gain);
}

}  // namespace fulcrum::app
