#include "haptics/bake/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr float kBoundRounding = 1.0f + 4e-6f;  // of squared bounds; that of coordinates is in the slack

struct Waiting {
  std::uint32_t reference;
  float bound;
};

// What sorts a node's children: nearest last, so that it is taken off the stack first.
template <std::size_t N>
std::size_t push_sorted(std::array<Waiting, N>& stack, std::size_t top, std::size_t base, Waiting entry) {
  std::size_t place = top;
  while (place > base && stack[place - 1].bound < entry.bound) {
    stack[place] = stack[place - 1];
    --place;
  }
  stack[place] = entry;
  return top + 1;
}

// Halves along the longest extent of the centres, at the median; ties by reference, so that the order is
// total.
template <class Item>
std::size_t split(std::span<Item> items) {
  Box3 centres;
  for (const Item& item : items) centres.extend(item.box.center());
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::size_t half = items.size() / 2;
  const auto key = [axis](const Item& item) { return item.box.min()[axis] + item.box.max()[axis]; };
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [&](const Item& left, const Item& right) {
                     const double l = key(left), r = key(right);
                     return l < r || (l == r && left.reference < right.reference);
                   });
  return half;
}

Box3 box_of(auto items) {
  Box3 box;
  for (const auto& item : items) box.extend(item.box);
  return box;
}

}  // namespace

TriangleTree::TriangleTree(const Solid& solid) : place_(solid.mesh.triangles.size(), kNone) {
  const Box3 bounds = solid.bounds();
  centre_ = bounds.center();
  // Float coordinates about the centre are off by at most 6e-8 of the half diagonal.
  slack_ = static_cast<float>(1e-6 * bounds.diagonal().norm());

  std::vector<Item> subtrees;
  for (const SolidComponent& component : solid.components) {
    std::vector<Item> items;
    items.reserve(component.triangle_count);
    for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
         ++t) {
      const Triangle& corner = solid.mesh.triangles[t];
      const Vec3 &a = solid.mesh.vertices[corner[0]], &b = solid.mesh.vertices[corner[1]],
                 &c = solid.mesh.vertices[corner[2]];
      if ((b - a).cross(c - a).squaredNorm() == 0.0) continue;
      Box3 box(a);
      box.extend(b).extend(c);
      items.push_back({box, t});
    }
    component_roots_.push_back(build(items, true, solid));
    subtrees.push_back({component.bounds, component_roots_.back()});
  }
  whole_ = build(subtrees, false, solid);
}

TriangleTree::Root TriangleTree::make_leaf(std::span<const Item> items, const Solid& solid) {
  const auto index = static_cast<std::uint32_t>(leaves_.size());
  Leaf leaf;
  for (Fence& fence : leaf) {  // an empty place is infinitely far
    fence.normal.fill(Eigen::Array4f::Zero());
    fence.offset = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
  }
  corners_.resize(corners_.size() + kLeafTriangles);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Triangle& corner = solid.mesh.triangles[items[i].reference];
    const std::array<Vec3, 3> v{solid.mesh.vertices[corner[0]], solid.mesh.vertices[corner[1]],
                                solid.mesh.vertices[corner[2]]};
    place_[items[i].reference] = static_cast<std::uint32_t>(kLeafTriangles * index + i);
    corners_[kLeafTriangles * index + i] = {v[0], v[1], v[2], items[i].reference};

    const Vec3 cross = (v[1] - v[0]).cross(v[2] - v[0]);
    const bool sliver = is_sliver(v[0], v[1], v[2]);  // its plane is rounding: bounds of zero
    const Vec3 n = sliver ? Vec3(Vec3::Zero()) : Vec3(cross.normalized());
    for (std::size_t f = 0; f < 4; ++f) {
      const Vec3 edge = f == 0 ? n : (v[f % 3] - v[f - 1]).normalized().cross(n);
      const auto lane = static_cast<Eigen::Index>(i);
      for (std::size_t axis = 0; axis < 3; ++axis)
        leaf[f].normal[axis][lane] = static_cast<float>(edge[static_cast<Eigen::Index>(axis)]);
      leaf[f].offset[lane] = static_cast<float>(-edge.dot(v[f == 0 ? 0 : f - 1] - centre_));
    }
  }
  leaves_.push_back(leaf);
  return kLeafBit | (static_cast<std::uint32_t>(items.size()) << 28) | index;
}

TriangleTree::Root TriangleTree::build(std::span<Item> items, bool of_triangles, const Solid& solid) {
  if (of_triangles && items.size() <= kLeafTriangles) return make_leaf(items, solid);
  if (!of_triangles && items.size() == 1) return items.front().reference;

  std::array<std::span<Item>, 4> parts;
  std::size_t count = 0;
  const std::size_t half = split(items);
  for (const std::span<Item> side : {items.first(half), items.subspan(half)}) {
    if (side.size() < 2) {
      parts[count++] = side;
    } else {
      const std::size_t quarter = split(side);
      parts[count++] = side.first(quarter);
      parts[count++] = side.subspan(quarter);
    }
  }

  const auto index = static_cast<Root>(nodes_.size());
  Node node;  // an empty place is infinitely far
  node.low.fill(Eigen::Array4f::Constant(std::numeric_limits<float>::infinity()));
  node.high.fill(Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity()));
  node.child.fill(kNone);
  nodes_.push_back(node);
  for (std::size_t i = 0; i < count; ++i) {
    const Box3 box = box_of(parts[i]);
    const Eigen::Vector3f low = (box.min() - centre_).cast<float>(),
                          high = (box.max() - centre_).cast<float>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low[axis][static_cast<Eigen::Index>(i)] = low[static_cast<Eigen::Index>(axis)] - slack_;
      node.high[axis][static_cast<Eigen::Index>(i)] = high[static_cast<Eigen::Index>(axis)] + slack_;
    }
    node.child[i] = build(parts[i], of_triangles, solid);
  }
  nodes_[index] = node;
  return index;
}

// Squares of lower bounds of the distances from centre_ + q to four boxes.
Eigen::Array4f TriangleTree::bounds_of(const Node& node, const Eigen::Vector3f& q) {
  const Eigen::Array4f x = (node.low[0] - q.x()).max(q.x() - node.high[0]).max(0.0f);
  const Eigen::Array4f y = (node.low[1] - q.y()).max(q.y() - node.high[1]).max(0.0f);
  const Eigen::Array4f z = (node.low[2] - q.z()).max(q.z() - node.high[2]).max(0.0f);
  return x * x + y * y + z * z;
}

// The same for the four triangles of a leaf.
Eigen::Array4f TriangleTree::bounds_of(const Leaf& leaf, const Eigen::Vector3f& q, float slack) {
  std::array<Eigen::Array4f, 4> beyond;
  for (std::size_t f = 0; f < 4; ++f) {
    beyond[f] =
        leaf[f].normal[0] * q.x() + leaf[f].normal[1] * q.y() + leaf[f].normal[2] * q.z() + leaf[f].offset;
  }
  const Eigen::Array4f above = (beyond[0].abs() - slack).max(0.0f);
  const Eigen::Array4f aside = (beyond[1].max(beyond[2]).max(beyond[3]) - slack).max(0.0f);
  return above * above + aside * aside;
}

TriangleTree::Nearest TriangleTree::nearest(Root root, const Vec3& p, double limit_squared,
                                            std::uint32_t hint) const {
  Nearest best;
  float reach = 0.0f;  // bounds above it cannot matter: the best so far, and the rounding of squared bounds
  const auto set_reach = [&] { reach = static_cast<float>(best.squared) * kBoundRounding; };
  best.squared = limit_squared;
  set_reach();
  const auto look_at = [&](const Corners& corners) {
    const TrianglePoint found = closest_on_triangle(p, corners.a, corners.b, corners.c);
    // Ties go to the lower index, so that the answer depends neither on the hint nor on the walk.
    if (found.squared < best.squared || (found.squared == best.squared && corners.triangle < best.triangle)) {
      best = {found.squared, corners.triangle, found.feature, found.point};
      set_reach();
    }
  };
  if (hint != kNone && place_[hint] != kNone) look_at(corners_[place_[hint]]);

  const Eigen::Vector3f q = (p - centre_).cast<float>();
  std::array<Waiting, kStack> stack;
  stack[0] = {root, 0.0f};
  std::size_t top = 1;
  while (top > 0) {
    const Waiting next = stack[--top];
    if (next.bound > reach) continue;
    alignas(16) std::array<float, 4> bounds;
    Eigen::Map<Eigen::Array4f, Eigen::Aligned16> all(bounds.data());
    if (is_leaf(next.reference)) {
      const std::uint32_t leaf = leaf_index(next.reference);
      all = bounds_of(leaves_[leaf], q, slack_);
      for (std::uint32_t i = 0; i < leaf_count(next.reference); ++i)
        if (bounds[i] <= reach) look_at(corners_[kLeafTriangles * leaf + i]);
      continue;
    }
    const Node& node = nodes_[next.reference];
    all = bounds_of(node, q);
    const std::size_t base = top;
    for (std::size_t i = 0; i < 4; ++i) {
      // An empty place is infinitely far; so is every place of a point that is, and then all have to be
      // tried.
      if (bounds[i] <= reach && node.child[i] != kNone)
        top = push_sorted(stack, top, base, {node.child[i], bounds[i]});
    }
  }
  return best;
}

}  // namespace fulcrum
