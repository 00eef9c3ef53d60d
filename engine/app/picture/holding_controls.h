#pragma once
// The panel of the holding point: what it shows of a tick, and what keys and presses on it ask of the next.

#include <optional>
#include <vector>

#include "engine/ui/holding_panel.h"
#include "engine/ui/overlay_state.h"
#include "haptics/tick/command.h"
#include "haptics/world/scene_desc.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

// Nothing where the scene has no holding point.
std::optional<ui::HoldingPanel> holding_panel(const SceneDesc& scene, const TickRecord& record);

// shown: what the panel showed last.
std::vector<Command> holding_commands(const ui::HoldingPanel& shown, const ui::HoldingPress& press);

enum class HoldingKey { nearer, farther, softer, stiffer, method, measured };
std::vector<Command> holding_commands(const ui::HoldingPanel& shown, HoldingKey key);

// "[ ]", "move the holding point", ...
std::vector<ui::KeyLine> holding_keys();

}  // namespace fulcrum::app
