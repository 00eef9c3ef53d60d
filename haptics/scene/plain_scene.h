#pragma once
// A scene without its effects, as plain data: the tool and what it touches, the hand's device, and what
// stands between them. Effects are built on it (effects/effects.h), and know no more of each other.

#include <algorithm>
#include <memory>
#include <optional>
#include <span>

#include "haptics/actuation/allocator.h"
#include "haptics/contact/contact_desc.h"
#include "haptics/contact/impact_detector.h"
#include "haptics/device/device.h"
#include "haptics/device/mapping.h"
#include "haptics/estimate/holding_point.h"
#include "haptics/estimate/velocity.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/geometry/object_map.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/tool/rigid_body.h"
#include "haptics/tool/tool_desc.h"
#include "haptics/tool/virtual_coupling.h"

namespace fulcrum {

struct PlainScene {
  double tick_s = 1e-3;
  ToolDesc tool;
  // Both or neither: contact on points. On triangles impacts alone read the field.
  std::shared_ptr<const Pointshell> tool_shell;
  std::shared_ptr<const DistanceField> scene_field;
  // For a constraint, both or neither: what of the scene could go in between the shell's points, against the
  // tool.
  std::shared_ptr<const Pointshell> scene_edges;    // in W
  std::shared_ptr<const DistanceField> tool_field;  // in T
  // For a constraint, both or neither: contact is measured on these in place of the shell, the field and the
  // scene's edges.
  std::shared_ptr<const FeatureMesh> tool_features{};   // in T
  std::shared_ptr<const FeatureMesh> scene_features{};  // in W
  ContactDesc contact;
  Integrator integrator = Integrator::semi_implicit_euler;
  CouplingDesc coupling;
  VelocityEstimatorDesc velocity;
  MappingDesc mapping;
  DeviceDesc device;
  AllocationDesc allocation;
  ImpactDetectorDesc impact;                         // where an effect asks for impacts
  std::shared_ptr<const ObjectMap> scene_objects{};  // where it matters; null: the scene is one object
  std::optional<HoldingPointDesc> holding_point{};
};

// m, from a place of the tool's (3, in T) to its farthest point.
inline double tool_reach(const PlainScene& scene, const Vec3& p_T) {
  double reach = 0;
  const auto count = [&](std::span<const Vec3> points) {
    for (const Vec3& q_T : points) reach = std::max(reach, (q_T - p_T).norm());
  };
  if (scene.tool_shell)
    count(scene.tool_shell->positions);
  else
    count(scene.tool_features->vertices());
  return reach;
}

// m, the same from T's origin.
inline double tool_radius(const PlainScene& scene) {
  return scene.tool_shell ? scene.tool_shell->max_radius_m : scene.tool_features->radius();
}

// (3) m, in T: of the places where the tool can be held, the one that is farthest from its centre of mass.
// scene: with a holding point.
inline Vec3 longest_grip(const PlainScene& scene) {
  const Pose X_TH = scene.tool.X_HT.inverse();
  const Vec3 low = X_TH * (scene.holding_point->low * scene.holding_point->axis_H);
  const Vec3 high = X_TH * (scene.holding_point->high * scene.holding_point->axis_H);
  return low.norm() > high.norm() ? low : high;
}

}  // namespace fulcrum
