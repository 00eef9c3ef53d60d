#include "haptics/geometry/feature_tree.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr std::uint32_t kLeaf = 4;  // features

}  // namespace

FeatureTree::FeatureTree(std::vector<TreeFeature> features) : features_(std::move(features)) {
  if (features_.empty()) return;
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(features_.size()));
}

void FeatureTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Box3 box, middles;
  const auto begin = features_.begin() + first, end = begin + count;
  for (auto feature = begin; feature != end; ++feature) {
    box.extend(feature->box);
    middles.extend(feature->box.center());
  }
  nodes_[node].box = box;
  nodes_[node].radius = 0.5 * box.diagonal().norm();
  if (count <= kLeaf) {
    NormalCone cone;
    for (auto feature = begin; feature != end; ++feature) cone = NormalCone::about(cone, feature->cone);
    nodes_[node].cone = cone;
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const TreeFeature& l, const TreeFeature& r) {
    const double a = l.box.center()[axis], b = r.box.center()[axis];
    return a < b || (a == b && l.which < r.which);
  });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = children;
  nodes_.resize(nodes_.size() + 2);
  split(children, first, half);
  split(children + 1, first + half, count - half);
  nodes_[node].cone = NormalCone::about(nodes_[children].cone, nodes_[children + 1].cone);
}

std::size_t FeatureTree::bytes() const {
  return features_.size() * sizeof(TreeFeature) + nodes_.size() * sizeof(Node);
}

}  // namespace fulcrum
