#pragma once
// The picture that a scene has its light from.

#include "engine/render/visual_desc.h"
#include "engine/scenario/scenario.h"

namespace fulcrum::scenario {

// As it is in the world: turned, and mirrored where the scenario is. A fault stands where the scenario names
// the file.
Checked<render::Panorama> read_surroundings(const Scenario& scenario, const SurroundingsEntry& entry);

}  // namespace fulcrum::scenario
