#pragma once
// A tree over features of one kind: where they lie, and where their normals point. Two surfaces are nearest
// to each other, locally, only where they are near and normals of theirs are opposite, and most of two parts
// that fit into each other is near: it is the normals that leave little over. D. E. Johnson, E. Cohen,
// "Spatialized normal cone hierarchies", I3D 2001.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/bounds.h"

namespace fulcrum {

struct TreeFeature {
  std::uint32_t which = 0;
  Box3 box{};  // m
  NormalCone cone{};
};

class FeatureTree {
public:
  static constexpr std::uint32_t kFeature = 1u << 31;  // of a child: the rest is a feature's `which`
  static constexpr std::uint32_t kNone = ~0u;          // no child
  // Up to four children, each another group or a feature.
  struct Group {
    Bounds4 bounds;
    std::array<std::uint32_t, 4> children{kNone, kNone, kNone, kNone};
  };

  FeatureTree() = default;
  explicit FeatureTree(std::vector<TreeFeature> features);

  std::span<const Group> groups() const { return groups_; }  // the first one holds all; none without features
  std::size_t bytes() const { return groups_.size() * sizeof(Group); }

private:
  struct Part;
  Part plant(std::span<TreeFeature> features);

  std::vector<Group> groups_;
};

}  // namespace fulcrum
