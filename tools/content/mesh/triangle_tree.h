#pragma once

#include <cstdint>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// Boxes around boxes around triangles, for exact distances.
class TriangleTree {
public:
  // Triangles are known by their index in the order they were added, over all solids.
  void add(const Solid& solid);
  void build();

  // Distance (m) from p to the nearest triangle if it is below `limit`, else `limit`.
  double distance(const Eigen::Vector3d& p, double limit) const;

  // Indices of the triangles whose box meets the box.
  std::vector<std::uint32_t> touching(const Eigen::AlignedBox3d& box) const;

private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t first = 0;   // of its triangles in order_
    std::uint32_t count = 0;   // 0 for a node with children
    std::uint32_t second = 0;  // its second child; the first follows the node itself
  };

  std::uint32_t build_node(std::uint32_t first, std::uint32_t count);
  Eigen::AlignedBox3d triangle_box(std::uint32_t triangle) const;

  std::vector<std::array<Eigen::Vector3d, 3>> corners_;  // (n x 3 x 3) m
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace fulcrum::content
