#include "haptics/geometry/feature_tree.h"

#include <algorithm>

namespace fulcrum {

// What a child stands for.
struct FeatureTree::Part {
  std::uint32_t child = 0;
  Box3 box{};
  NormalCone cone{};
};

namespace {

// Into a lower and an upper half, along the axis on which they lie farthest apart.
std::size_t split_features(std::span<TreeFeature> features) {
  Box3 middles;
  for (const TreeFeature& feature : features) middles.extend(feature.box.center());
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const auto half = features.begin() + static_cast<std::ptrdiff_t>(features.size() / 2);
  std::nth_element(features.begin(), half, features.end(),
                   [axis](const TreeFeature& l, const TreeFeature& r) {
                     const double a = l.box.center()[axis], b = r.box.center()[axis];
                     return a < b || (a == b && l.which < r.which);
                   });
  return features.size() / 2;
}

}  // namespace

FeatureTree::FeatureTree(std::vector<TreeFeature> features) {
  if (features.size() == 1) {
    // A group of its own, so that there is one.
    groups_.emplace_back();
    groups_[0].bounds.set(0, Bounds::of(features[0].box, features[0].cone));
    groups_[0].children[0] = features[0].which | kFeature;
  } else if (!features.empty()) {
    plant(features);
  }
}

FeatureTree::Part FeatureTree::plant(std::span<TreeFeature> features) {
  if (features.size() == 1) return {features[0].which | kFeature, features[0].box, features[0].cone};
  Part whole{static_cast<std::uint32_t>(groups_.size()), {}, {}};
  groups_.emplace_back();
  unsigned lane = 0;
  const auto add = [&](std::span<TreeFeature> some) {
    if (some.empty()) return;
    const Part part = plant(some);
    groups_[whole.child].bounds.set(lane, Bounds::of(part.box, part.cone));
    groups_[whole.child].children[lane++] = part.child;
    whole.box.extend(part.box);
    whole.cone = NormalCone::about(whole.cone, part.cone);
  };
  const std::size_t half = split_features(features);
  for (const std::span<TreeFeature> part : {features.first(half), features.subspan(half)}) {
    if (part.size() < 2) {
      add(part);
      continue;
    }
    const std::size_t quarter = split_features(part);
    add(part.first(quarter));
    add(part.subspan(quarter));
  }
  return whole;
}

}  // namespace fulcrum
