#pragma once
// The list of what effects leave behind in a tick.

#include <optional>

#include "haptics/effects/braking_pulse/pulse_record.h"
#include "haptics/effects/impact_vibration/impact_vibration_record.h"
#include "haptics/effects/inertia_compensation/inertia_record.h"
#include "haptics/effects/texture/texture_record.h"
#include "haptics/effects/torque_substitution/torque_record.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_record.h"

namespace fulcrum {

// Of those that are built.
struct EffectRecords {
  std::optional<TorqueRecord> torque_substitution{};
  std::optional<ImpactVibrationRecord> impact_vibration{};
  std::optional<PulseRecord> braking_pulse{};
  std::optional<VibrotactileRecord> vibrotactile_motion{};
  std::optional<InertiaRecord> inertia_compensation{};
  std::optional<TextureRecord> texture{};
};

template <class V>
void describe(V& values, const EffectRecords& records) {
  const auto& [torque_substitution, impact_vibration, braking_pulse, vibrotactile_motion,
               inertia_compensation, texture] = records;
  const auto describe_built = [&values](const auto& record) {
    if (record) describe(values, *record);
  };
  describe_built(torque_substitution);
  describe_built(impact_vibration);
  describe_built(braking_pulse);
  describe_built(vibrotactile_motion);
  describe_built(inertia_compensation);
  describe_built(texture);
}

}  // namespace fulcrum
