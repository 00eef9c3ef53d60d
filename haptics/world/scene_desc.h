#pragma once
// A scene as plain data. World::build() turns it into what ticks; a part that is not named here is not built.

#include "haptics/effects/effects.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

struct SceneDesc : PlainScene, EffectDescs {};

// A device that renders torque has nothing to substitute.
inline bool substitutes_torque(const SceneDesc& desc) {
  return desc.torque_substitution && !desc.device.renders_torque;
}

// It shows the turn between hand and tool, where the device senses one.
inline bool shows_ghost(const SceneDesc& desc) {
  return substitutes_torque(desc) && desc.device.senses_rotation;
}

// It vibrates the handle, where the device has motors.
inline bool vibrates_for_torque(const SceneDesc& desc) {
  return substitutes_torque(desc) && desc.device.renders_force;
}

// A device without motors has nothing to vibrate with.
inline bool vibrates_at_impacts(const SceneDesc& desc) {
  return desc.impact_vibration && (desc.device.renders_force || desc.device.renders_torque);
}

// A device that does not push cannot brake.
inline bool brakes_at_impacts(const SceneDesc& desc) {
  return desc.braking_pulse && desc.device.renders_force;
}

// A device that does not push can make up for nothing.
inline bool compensates_inertia(const SceneDesc& desc) {
  return desc.inertia_compensation && desc.device.renders_force;
}

// Something in the scene asks for impacts.
inline bool detects_impacts(const SceneDesc& desc) {
  return asks_for_impacts(desc, desc);
}

// As a fallback it is for a device that has channels and no motors. Else it needs channels, or a device that
// pushes and a lateral force.
inline bool moves_vibration(const SceneDesc& desc) {
  if (!desc.vibrotactile_motion) return false;
  const bool channels = desc.device.vibrotactile.has_value();
  if (desc.vibrotactile_motion->use == VibrotactileUse::fallback)
    return channels && !desc.device.renders_force && !desc.device.renders_torque;
  return channels || (desc.device.renders_force && desc.vibrotactile_motion->lateral_force > 0);
}

inline bool vibrates_channels(const SceneDesc& desc) {
  return moves_vibration(desc) && desc.device.vibrotactile.has_value();
}

}  // namespace fulcrum
