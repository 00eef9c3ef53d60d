#pragma once
// The cues of a scene, switched and set by a person: what a key or a press on their panel asks of the tick.

#include <optional>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/overlay_state.h"
#include "haptics/tick/command.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum::app {

class CueSwitches {
public:
  CueSwitches() = default;  // of a scene without cues
  explicit CueSwitches(const SceneDesc& scene);

  // shown: what the panel showed last. Nothing: the scene has no such cue.
  std::optional<Command> toggle(Command::Kind kind, const ui::OverlayState& shown);
  // A press at (x, y), in fractions of the height of a picture of that size, from its top left. Nothing: it
  // was not on the panel.
  std::optional<Command> press(const ui::OverlayState& shown, render::Extent size, double x, double y);

private:
  Command set(std::size_t cue, double gain);

  std::vector<Command::Kind> kinds_;  // in the order of OverlayState::cues
  std::vector<double> switched_on_;   // gain of each when it is switched on again
};

}  // namespace fulcrum::app
