#pragma once
// A scene as plain data. World::build() turns it into what ticks; a part that is not named here is not built.

#include <memory>
#include <optional>

#include "haptics/actuation/allocator.h"
#include "haptics/contact/contact_desc.h"
#include "haptics/device/device.h"
#include "haptics/device/mapping.h"
#include "haptics/effects/torque_substitution.h"
#include "haptics/estimate/velocity.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"
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
  std::optional<TorqueSubstitutionDesc> torque_substitution;
};

// A device that renders torque has nothing to substitute.
inline bool substitutes_torque(const SceneDesc& desc) {
  return desc.torque_substitution && !desc.device.renders_torque;
}

// It shows the turn between hand and tool, where the device senses one.
inline bool shows_ghost(const SceneDesc& desc) {
  return substitutes_torque(desc) && desc.device.senses_rotation;
}

// Something in the scene asks for forces that no slew limit slows down.
inline bool has_transients(const SceneDesc& desc) {
  return substitutes_torque(desc) && desc.device.renders_force;
}

}  // namespace fulcrum
