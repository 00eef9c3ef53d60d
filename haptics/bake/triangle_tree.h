#pragma once
// A tree of boxes, four to a node, over a solid's triangles: one subtree per component and nodes above them
// that join the subtrees. Answers do not depend on the order in which the tree is walked.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "haptics/bake/solid.h"
#include "haptics/geometry/point_triangle.h"

namespace fulcrum {

class TriangleTree {
public:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  using Root = std::uint32_t;

  struct Nearest {
    double squared = 0.0;            // m^2, of the distance
    std::uint32_t triangle = kNone;  // into Solid::mesh.triangles; kNone: nothing within the limit
    TriangleFeature feature = TriangleFeature::face;
    Vec3 point = Vec3::Zero();  // (3) m
  };
  struct Hit {
    std::uint32_t triangle = 0;  // into Solid::mesh.triangles
    double fraction = 0.0;       // of the way from p0 to p1
  };

  // Triangles without area are left out: their neighbours' edges cover them.
  explicit TriangleTree(const Solid& solid);

  Root whole() const { return whole_; }
  Root of_component(std::uint32_t component) const { return component_roots_[component]; }

  // The closest point nearer than sqrt(limit_squared). `hint`: a triangle to try first, or kNone.
  Nearest nearest(Root root, const Vec3& p, double limit_squared, std::uint32_t hint) const;
  // The closest point of one triangle that has an area.
  Vec3 closest_on(std::uint32_t triangle, const Vec3& p) const {
    const Corners& corners = corners_[place_[triangle]];
    return closest_on_triangle(p, corners.a, corners.b, corners.c).point;
  }
  // The first triangle that the segment meets; of several at one place, the one with the lowest index.
  std::optional<Hit> first_hit(Root root, const Vec3& p0, const Vec3& p1) const;
  // Appends every triangle whose leaf's box meets `box`, and maybe a few more.
  void near_box(Root root, const Box3& box, std::vector<std::uint32_t>& found) const;
  // Calls visit(triangle) for every triangle but those in a box that the caller rules out: the box lies
  // within `radius` of `centre`, both m, and rules_out(centre, radius) answers whether nothing there matters.
  template <class RulesOut, class Visit>
  void visit_unless(Root root, RulesOut&& rules_out, Visit&& visit) const;

private:
  static constexpr Root kLeafBit = 0x80000000u;  // of a reference: a leaf, 3 bits of count, 28 bits of place
  static constexpr std::size_t kStack =
      256;  // 16 levels of four hold 2^32 triangles; three siblings wait on each
  static constexpr std::uint32_t kLeafTriangles = 4;
  static bool is_leaf(Root reference) { return (reference & kLeafBit) != 0; }
  static std::uint32_t leaf_count(Root reference) { return (reference >> 28) & 7u; }
  static std::uint32_t leaf_index(Root reference) { return reference & 0x0fffffffu; }  // into leaves_

  struct Node {  // boxes as floats about centre_, grown by more than the rounding
    std::array<Eigen::Array4f, 3> low, high;  // per axis, of the four children
    std::array<Root, 4> child;
  };
  struct Corners {
    Vec3 a, b, c;
    std::uint32_t triangle;
  };
  // Four triangles of a leaf, each as its plane and, across it, its three edges: plane distance and the
  // largest distance beyond an edge bound the distance to the triangle from below, for all four at once.
  struct Fence {
    std::array<Eigen::Array4f, 3> normal;  // unit; [0] the plane's, then outwards across the edges
    Eigen::Array4f offset;
  };
  using Leaf = std::array<Fence, 4>;
  struct Item {  // while building: a triangle, or the finished subtree of a component
    Box3 box;
    Root reference;
  };

  Root build(std::span<Item> items, bool of_triangles, const Solid& solid);
  Root make_leaf(std::span<const Item> items, const Solid& solid);
  static Eigen::Array4f bounds_of(const Node& node, const Eigen::Vector3f& q);
  static Eigen::Array4f bounds_of(const Leaf& leaf, const Eigen::Vector3f& q, float slack);

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<Corners> corners_;      // (leaves x 4), a leaf's at four times its index
  std::vector<std::uint32_t> place_;  // (m) where a triangle lies in corners_, kNone: it has no area
  std::vector<Root> component_roots_;
  Root whole_ = kNone;
  Vec3 centre_ = Vec3::Zero();
  float slack_ = 0.0f;  // m, how far boxes are grown
};

template <class RulesOut, class Visit>
void TriangleTree::visit_unless(Root root, RulesOut&& rules_out, Visit&& visit) const {
  std::array<Root, kStack> stack;
  stack[0] = root;
  std::size_t top = 1;
  while (top > 0) {
    const Root next = stack[--top];
    if (is_leaf(next)) {
      const std::uint32_t begin = kLeafTriangles * leaf_index(next);
      for (std::uint32_t i = begin; i < begin + leaf_count(next); ++i) visit(corners_[i].triangle);
      continue;
    }
    const Node& node = nodes_[next];
    for (std::size_t i = 0; i < 4; ++i) {
      if (node.child[i] == kNone) continue;
      const auto child = static_cast<Eigen::Index>(i);
      const Vec3 low(node.low[0][child], node.low[1][child], node.low[2][child]);
      const Vec3 high(node.high[0][child], node.high[1][child], node.high[2][child]);
      const Vec3 middle = (low + high) / 2;
      if (!rules_out(Vec3(centre_ + middle), (high - middle).norm())) stack[top++] = node.child[i];
    }
  }
}

}  // namespace fulcrum
