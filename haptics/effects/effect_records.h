#pragma once
// The list of what effects leave behind in a tick.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "haptics/effects/braking_pulse/pulse_record.h"
#include "haptics/effects/guidance/guidance_record.h"
#include "haptics/effects/impact_vibration/impact_vibration_record.h"
#include "haptics/effects/inertia_compensation/inertia_record.h"
#include "haptics/effects/texture/texture_record.h"
#include "haptics/effects/torque_substitution/torque_record.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_record.h"
#include "haptics/effects/workspace_walls/workspace_walls_record.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What the effects from outside haptics/effects leave behind, all of them together.
class OwnRecord {
public:
  static constexpr std::size_t kMaxValues = 8;
  struct Value {
    const Quantity* what = nullptr;
    double value = 0;
  };

  // An effect adds the same values in the same order in every tick. what: outlives the record. Its name
  // begins with the effect's, which no other column does. World::build() refuses other names, and more values
  // than kMaxValues.
  void add(const Quantity& what, double value) noexcept {
    if (size_ < kMaxValues) values_[size_] = {&what, value};
    ++size_;
  }
  void add(const Quantity&& what, double value) = delete;

  std::span<const Value> values() const { return std::span(values_).first(std::min(size_, kMaxValues)); }
  bool fits() const { return size_ <= kMaxValues; }

private:
  std::array<Value, kMaxValues> values_{};
  std::size_t size_ = 0;
};

template <class V>
void describe(V& values, const OwnRecord& record) {
  for (const auto& [what, value] : record.values()) values.number(*what, value);
}

// Of those that are built.
struct EffectRecords {
  std::optional<TorqueRecord> torque_substitution{};
  std::optional<ImpactVibrationRecord> impact_vibration{};
  std::optional<PulseRecord> braking_pulse{};
  std::optional<VibrotactileRecord> vibrotactile_motion{};
  std::optional<InertiaRecord> inertia_compensation{};
  std::optional<TextureRecord> texture{};
  std::optional<WorkspaceWallsRecord> workspace_walls{};
  std::optional<GuidanceRecord> guidance{};
  OwnRecord own{};
};

// What the device's channels were told; null: nothing drives them.
inline const VibrotactileCommand* channel_command(const EffectRecords& records) {
  return records.vibrotactile_motion ? &records.vibrotactile_motion->command : nullptr;
}

// How plainly the tool is drawn once more where the hand has turned to, 0 to 1.
inline double ghost_opacity(const EffectRecords& records) {
  return records.torque_substitution ? records.torque_substitution->ghost : 0;
}

// The person was led, or had asked for it: such a tick tells nothing of what they can do by themselves.
inline bool guided(const EffectRecords& records) {
  return records.guidance && (records.guidance->gain > 0 || records.guidance->level > 0);
}

// The expert's tool where it would be a little later, and how plainly it is drawn.
struct ExpertAhead {
  double opacity = 0;  // 0 to 1
  Pose X_WT;
};
// Absent: no effect leads along the expert's way.
inline std::optional<ExpertAhead> expert_ahead(const EffectRecords& records) {
  if (!records.guidance) return std::nullopt;
  return ExpertAhead{records.guidance->level, records.guidance->X_WT_ahead};
}

// Where else the newest impact would have felt the same, but for its frequency: on a circle about the handle.
struct ImpactCircle {
  Vec3 axis_W = Vec3::Zero();  // (3) unit; zero where the hand was turned about none
  double radius = 0;           // m
};
// Absent: no effect tells where an impact was, or none was told of yet.
inline std::optional<ImpactCircle> impact_circle(const EffectRecords& records) {
  const auto& told = records.impact_vibration;
  if (!told || told->gain == 0 || told->frequency_Hz == 0) return std::nullopt;
  return ImpactCircle{told->axis_W, told->radius};
}

template <class V>
void describe(V& values, const EffectRecords& records) {
  const auto& [torque_substitution, impact_vibration, braking_pulse, vibrotactile_motion,
               inertia_compensation, texture, workspace_walls, guidance, own] = records;
  const auto describe_built = [&values](const auto& record) {
    if (record) describe(values, *record);
  };
  describe_built(torque_substitution);
  describe_built(impact_vibration);
  describe_built(braking_pulse);
  describe_built(vibrotactile_motion);
  describe_built(inertia_compensation);
  describe_built(texture);
  describe_built(workspace_walls);
  describe_built(guidance);
  describe(values, own);
}

}  // namespace fulcrum
