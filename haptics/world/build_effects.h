#pragma once
// The effects of a scene, from what it names and what its device can do.

#include <optional>

#include "haptics/effects/torque_substitution.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum {

// Absent where the scene does not name it or has no use for it, see substitutes_torque().
std::optional<TorqueSubstitution> build_torque_substitution(const SceneDesc& desc);

}  // namespace fulcrum
