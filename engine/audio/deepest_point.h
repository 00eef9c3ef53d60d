#pragma once
// Where a tool touches: the place of it that lies nearest to the scene, or deepest in it, of its shell's points
// or on its triangles. For who has no tick's contacts, and asks seldom.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "haptics/contact/feature_pairs.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"

namespace fulcrum::audio {

struct DeepestPoint {
  Vec3 p_T = Vec3::Zero();     // (3) m, of the tool
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, out of the scene
};

class DeepestPointFinder {
public:
  // Every n-th point of a larger shell: a shell is sorted by place, and so what is left covers it all.
  static constexpr std::size_t kProbes = 4096;

  // Either may be null: then nothing touches.
  DeepestPointFinder(const Pointshell* tool_shell, std::shared_ptr<const DistanceField> scene_field);
  // On triangles: neither is null.
  DeepestPointFinder(std::shared_ptr<const FeatureMesh> tool_T, std::shared_ptr<const FeatureMesh> scene_W)
      : pairs_(std::in_place, std::move(tool_T), std::move(scene_W)) {}

  // None: the pose is no number, or no direction is known there; on triangles, nothing is near.
  std::optional<DeepestPoint> find(const Pose& X_WT);

private:
  std::optional<DeepestPoint> nearest_pair(const Pose& X_WT);

  std::optional<FeaturePairs> pairs_;
  std::shared_ptr<const DistanceField> field_;
  std::vector<Vec3> probes_T_;
};

}  // namespace fulcrum::audio
