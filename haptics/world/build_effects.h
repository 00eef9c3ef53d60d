#pragma once
// The effects of a scene, from what it names and what its device can do.

#include <optional>

#include "haptics/contact/impact_detector.h"
#include "haptics/effects/impact_vibration.h"
#include "haptics/effects/torque_substitution.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum {

// Absent where the scene does not name it or has no use for it, see substitutes_torque().
std::optional<TorqueSubstitution> build_torque_substitution(const SceneDesc& desc);

// Absent where nothing in the scene asks for impacts.
std::optional<ImpactDetector> build_impact_detector(const SceneDesc& desc);

// Absent where the scene does not name it or the device has no motors.
std::optional<ImpactVibration> build_impact_vibration(const SceneDesc& desc);

std::optional<BrakingPulse> build_braking_pulse(const SceneDesc& desc);

// Absent where the scene does not name it or the device has no use for it, see moves_vibration().
std::optional<VibrotactileMotion> build_vibrotactile_motion(const SceneDesc& desc);

std::optional<HoldingPoint> build_holding_point(const SceneDesc& desc);

// Absent where the scene does not name it or the device does not push.
std::optional<InertiaCompensation> build_inertia_compensation(const SceneDesc& desc);

}  // namespace fulcrum
