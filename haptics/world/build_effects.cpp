#include "haptics/world/build_effects.h"

namespace fulcrum {

std::optional<TorqueSubstitution> build_torque_substitution(const SceneDesc& desc) {
  if (!substitutes_torque(desc)) return std::nullopt;
  return TorqueSubstitution(*desc.torque_substitution,
                            {.tick_s = desc.tick_s,
                             .tool_reach = desc.tool_shell->max_radius_m,
                             .max_force = desc.coupling.max_force,
                             .max_torque = desc.coupling.max_torque,
                             .renders_force = desc.device.renders_force,
                             .senses_rotation = desc.device.senses_rotation,
                             .springs = desc.contact.response != ContactResponse::constraint});
}

}  // namespace fulcrum
