#pragma once
// The knobs of a scene's effects in a person's hand: what a key or a press on their panel asks of the tick.

#include <optional>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/overlay_state.h"
#include "haptics/tick/knob.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum::app {

class CueSwitches {
public:
  CueSwitches() = default;  // of a scene without any
  explicit CueSwitches(const SceneDesc& scene);

  // shown: what the panel showed last. Nothing: no knob has that key.
  std::optional<Command> toggle(char key, const ui::OverlayState& shown);
  // A press at (x, y), in fractions of the height of a picture of that size, from its top left. Nothing: it
  // was not on the panel.
  std::optional<Command> press(const ui::OverlayState& shown, render::Extent size, double x, double y);

private:
  Command set(std::size_t cue, double gain);

  std::vector<Knob> knobs_;          // in the order of OverlayState::cues
  std::vector<double> switched_on_;  // gain of each when it is switched on again
};

}  // namespace fulcrum::app
