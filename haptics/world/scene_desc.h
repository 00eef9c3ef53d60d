#pragma once
// A scene as plain data. World::build() turns it into what ticks; a part that is not named here is not built.

#include <memory>
#include <optional>
#include <vector>

#include "haptics/actuation/allocator.h"
#include "haptics/contact/contact_desc.h"
#include "haptics/contact/impact_detector.h"
#include "haptics/device/device.h"
#include "haptics/device/mapping.h"
#include "haptics/effects/braking_pulse.h"
#include "haptics/effects/impact_vibration.h"
#include "haptics/effects/inertia_compensation.h"
#include "haptics/effects/torque_substitution.h"
#include "haptics/effects/vibrotactile_motion.h"
#include "haptics/estimate/holding_point.h"
#include "haptics/estimate/velocity.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/object_map.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"
#include "haptics/safety/transient_budget.h"
#include "haptics/tool/rigid_body.h"
#include "haptics/tool/virtual_coupling.h"

namespace fulcrum {

struct ToolDesc {
  double mass = 0.2;                  // kg
  Mat3 inertia_T = Mat3::Identity();  // (3 x 3) kg m^2, about the centre of mass, in T
  Pose X_HT;                          // the tool in the handle, when nothing touches it
  Pose X_WT_start;                    // where the tool is at tick 0
  bool weight = true;                 // gravity acts on the tool, and the hand feels it
};

// N
inline double tool_weight(const ToolDesc& tool) {
  constexpr double gravity = 9.80665;  // m/s^2
  return tool.weight ? gravity * tool.mass : 0.0;
}

struct SceneDesc {
  double tick_s = 1e-3;
  ToolDesc tool;
  std::shared_ptr<const Pointshell> tool_shell;
  std::shared_ptr<const DistanceField> scene_field;
  // For a constraint, both or neither: what of the scene could go in between the shell's points, against the
  // tool.
  std::shared_ptr<const Pointshell> scene_edges;    // in W
  std::shared_ptr<const DistanceField> tool_field;  // in T
  ContactDesc contact;
  Integrator integrator = Integrator::semi_implicit_euler;
  CouplingDesc coupling;
  VelocityEstimatorDesc velocity;
  MappingDesc mapping;
  DeviceDesc device;
  AllocationDesc allocation;
  ImpactDetectorDesc impact;                         // where something asks for impacts
  std::shared_ptr<const ObjectMap> scene_objects{};  // where it matters; null: the scene is one object
  std::optional<TorqueSubstitutionDesc> torque_substitution;
  std::optional<ImpactVibrationDesc> impact_vibration{};
  std::optional<BrakingPulseDesc> braking_pulse{};
  std::optional<VibrotactileMotionDesc> vibrotactile_motion{};
  std::optional<HoldingPointDesc> holding_point{};
  std::optional<InertiaCompensationDesc> inertia_compensation{};
};

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

// (3) m, in T: of the places where the tool can be held, the one that is farthest from its centre of mass.
inline Vec3 longest_grip(const SceneDesc& desc) {
  const Pose X_TH = desc.tool.X_HT.inverse();
  const Vec3 low = X_TH * (desc.holding_point->low * desc.holding_point->axis_H);
  const Vec3 high = X_TH * (desc.holding_point->high * desc.holding_point->axis_H);
  return low.norm() > high.norm() ? low : high;
}

// Something in the scene asks for impacts.
inline bool detects_impacts(const SceneDesc& desc) {
  return vibrates_at_impacts(desc) || brakes_at_impacts(desc);
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

// What in the scene asks for wrenches that no slew limit slows down.
inline std::vector<TransientSource> transient_sources(const SceneDesc& desc) {
  std::vector<TransientSource> sources;
  if (brakes_at_impacts(desc)) sources.push_back(TransientSource::braking_pulse);
  if (vibrates_for_torque(desc)) sources.push_back(TransientSource::torque_substitution);
  if (vibrates_at_impacts(desc)) sources.push_back(TransientSource::impact_vibration);
  return sources;
}

}  // namespace fulcrum
