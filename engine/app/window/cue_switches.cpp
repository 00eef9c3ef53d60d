#include "engine/app/window/cue_switches.h"

#include <algorithm>

#include "engine/ui/cue_panel.h"
#include "haptics/effects/effects.h"

namespace fulcrum::app {

CueSwitches::CueSwitches(const SceneDesc& scene) : knobs_(effect_knobs(scene, scene, {})) {
  for (const Knob& knob : knobs_) switched_on_.push_back(knob.on);
}

Command CueSwitches::set(std::size_t cue, double gain) {
  if (gain > 0) switched_on_[cue] = gain;
  return {knobs_[cue].kind, gain};
}

std::optional<Command> CueSwitches::toggle(char key, const ui::OverlayState& shown) {
  const auto cue = static_cast<std::size_t>(std::ranges::find(knobs_, key, &Knob::key) - knobs_.begin());
  if (cue >= std::min(knobs_.size(), shown.cues.size())) return std::nullopt;
  return set(cue, shown.cues[cue].gain > 0 ? 0.0 : switched_on_[cue]);
}

std::optional<Command> CueSwitches::press(const ui::OverlayState& shown, render::Extent size, double x,
                                          double y) {
  const auto press = ui::pressed_cue(shown, switched_on_, ui::panel_point(size, shown.look, x, y));
  if (!press) return std::nullopt;
  return set(press->cue, press->gain);
}

}  // namespace fulcrum::app
