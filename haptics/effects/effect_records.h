#pragma once
// The list of what effects leave behind in a tick.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "haptics/effects/braking_pulse/pulse_record.h"
#include "haptics/effects/impact_vibration/impact_vibration_record.h"
#include "haptics/effects/inertia_compensation/inertia_record.h"
#include "haptics/effects/texture/texture_record.h"
#include "haptics/effects/torque_substitution/torque_record.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_record.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What an effect from outside haptics/effects leaves behind.
struct OwnRecord {
  static constexpr std::size_t kMaxValues = 8;
  std::span<const Quantity> what{};  // of the values, kMaxValues at most; it outlives the record
  std::array<double, kMaxValues> value{};
};

template <class V>
void describe(V& values, const OwnRecord& record) {
  const auto& [what, value] = record;
  for (std::size_t i = 0; i < std::min(what.size(), value.size()); ++i) values.number(what[i], value[i]);
}

// Of those that are built.
struct EffectRecords {
  std::optional<TorqueRecord> torque_substitution{};
  std::optional<ImpactVibrationRecord> impact_vibration{};
  std::optional<PulseRecord> braking_pulse{};
  std::optional<VibrotactileRecord> vibrotactile_motion{};
  std::optional<InertiaRecord> inertia_compensation{};
  std::optional<TextureRecord> texture{};
  std::optional<OwnRecord> own{};
};

template <class V>
void describe(V& values, const EffectRecords& records) {
  const auto& [torque_substitution, impact_vibration, braking_pulse, vibrotactile_motion,
               inertia_compensation, texture, own] = records;
  const auto describe_built = [&values](const auto& record) {
    if (record) describe(values, *record);
  };
  describe_built(torque_substitution);
  describe_built(impact_vibration);
  describe_built(braking_pulse);
  describe_built(vibrotactile_motion);
  describe_built(inertia_compensation);
  describe_built(texture);
  describe_built(own);
}

}  // namespace fulcrum
