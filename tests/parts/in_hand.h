#pragma once
// A part in a hand, in another part: contact on triangles, on a device that only tells where the hand is.

#include <gtest/gtest.h>

#include <memory>

#include "haptics/bake/solid.h"
#include "haptics/world/world.h"

namespace fulcrum::parts {

inline std::shared_ptr<const FeatureMesh> features_of(const TriangleMesh& mesh) {
  const Result<Solid> solid = build_solid(mesh);
  EXPECT_TRUE(solid) << solid.error().sentence;
  return std::make_shared<const FeatureMesh>(solid->mesh, solid->neighbours);
}

inline SceneDesc in_hand(const TriangleMesh& tool_T, const TriangleMesh& scene_W) {
  SceneDesc desc;
  desc.tool_features = features_of(tool_T);
  desc.scene_features = features_of(scene_W);
  desc.tool.weight = false;
  desc.device.kinematics = Kinematics::none;
  desc.device.renders_force = false;
  desc.device.senses_rotation = true;
  return desc;
}

// The hand holds the tool at X_WT, or would.
inline StepResult tick(World& world, const SceneDesc& desc, const Pose& X_WT) {
  DeviceSample sample;
  sample.X_DH = desc.mapping.handle_in_device(X_WT * desc.tool.X_HT.inverse());
  sample.connected = true;
  return step(world, sample, {});
}

}  // namespace fulcrum::parts
