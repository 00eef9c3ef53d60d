#include "engine/audio/deepest_point.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace fulcrum::audio {

DeepestPointFinder::DeepestPointFinder(const Pointshell* tool_shell,
                                       std::shared_ptr<const DistanceField> scene_field)
    : field_(std::move(scene_field)) {
  if (tool_shell == nullptr) return;
  const std::size_t every = 1 + (tool_shell->size() - 1) / kProbes;
  for (std::size_t i = 0; i < tool_shell->size(); i += every) probes_T_.push_back(tool_shell->positions[i]);
}

std::optional<DeepestPoint> DeepestPointFinder::nearest_pair(const Pose& X_WT) {
  pairs_->look(X_WT, FeaturePairs::kDeepest);
  const std::span<const FeaturePair> pairs = pairs_->pairs();
  if (pairs.empty()) return std::nullopt;
  const FeaturePair& nearest = *std::ranges::min_element(pairs, {}, &FeaturePair::gap);
  return DeepestPoint{X_WT.inverse() * nearest.p_W, nearest.nhat_W};
}

std::optional<DeepestPoint> DeepestPointFinder::find(const Pose& X_WT) {
  if (!X_WT.is_finite()) return std::nullopt;
  if (pairs_) return nearest_pair(X_WT);
  if (!field_) return std::nullopt;
  const Vec3* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& p_T : probes_T_) {
    const double distance = field_->distance(X_WT * p_T);
    if (!(distance < least)) continue;
    least = distance;
    nearest = &p_T;
  }
  if (nearest == nullptr) return std::nullopt;
  const Vec3 nhat_W = field_->sample(X_WT * *nearest).gradient;
  if (!nhat_W.allFinite()) return std::nullopt;
  return DeepestPoint{*nearest, nhat_W};
}

}  // namespace fulcrum::audio
