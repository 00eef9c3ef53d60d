#pragma once
// The list of what effects leave behind in a tick.

#include <optional>

#include "haptics/effects/braking_pulse/pulse_cues.h"
#include "haptics/effects/impact_vibration/impact_cues.h"
#include "haptics/effects/inertia_compensation/inertia_cues.h"
#include "haptics/effects/torque_substitution/torque_cues.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_cues.h"

namespace fulcrum {

// Of those that are built.
struct EffectRecords {
  TorqueCues torque;                               // of torque substitution; zero where it is not built
  std::optional<ImpactCues> impact_vibration{};    // where it is built
  std::optional<PulseCues> pulse{};                // likewise
  std::optional<VibrotactileCues> vibrotactile{};  // likewise
  std::optional<InertiaCues> inertia{};            // likewise
};

}  // namespace fulcrum
