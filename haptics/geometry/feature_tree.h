#pragma once
// A tree over features of one kind: where they lie, and where their normals point. Two surfaces are nearest
// to each other, locally, only where they are near and normals of theirs are opposite, and most of two parts
// that fit into each other is near: it is the normals that leave little over. D. E. Johnson, E. Cohen,
// "Spatialized normal cone hierarchies", I3D 2001.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/normal_cone.h"
#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

struct TreeFeature {
  std::uint32_t which = 0;
  Box3 box{};  // m
  NormalCone cone{};
};

class FeatureTree {
public:
  struct Node {
    Box3 box{};         // m
    double radius = 0;  // m, about the box's centre
    NormalCone cone{};
    std::uint32_t first = 0;  // of an inner node: its children are nodes first and first + 1
    std::uint32_t count = 0;  // features of a leaf; 0: an inner node
  };

  FeatureTree() = default;
  explicit FeatureTree(std::vector<TreeFeature> features);

  bool empty() const { return features_.empty(); }
  std::size_t nodes() const { return nodes_.size(); }
  std::size_t features() const { return features_.size(); }
  const Node& node(std::uint32_t i) const { return nodes_[i]; }  // 0: all of it
  std::span<const TreeFeature> of(const Node& leaf) const {
    return std::span(features_).subspan(leaf.first, leaf.count);
  }
  std::size_t bytes() const;

private:
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);

  std::vector<TreeFeature> features_;
  std::vector<Node> nodes_;
};

}  // namespace fulcrum
