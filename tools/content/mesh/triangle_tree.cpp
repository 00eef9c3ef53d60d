#include "tools/content/mesh/triangle_tree.h"

// Nearest point of a triangle: Ericson, "Real-Time Collision Detection", 5.1.5.

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t leaf_size = 4;

Vector3d nearest_on_triangle(const Vector3d& p, const std::array<Vector3d, 3>& t) {
  const Vector3d ab = t[1] - t[0];
  const Vector3d ac = t[2] - t[0];
  const Vector3d ap = p - t[0];
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return t[0];
  const Vector3d bp = p - t[1];
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return t[0] + d1 / (d1 - d3) * ab;
  const Vector3d cp = p - t[2];
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return t[0] + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]);
  const double scale = 1.0 / (va + vb + vc);
  return t[0] + vb * scale * ab + vc * scale * ac;
}

}  // namespace

void TriangleTree::add(const Solid& solid) {
  for (const Triangle& t : solid.triangles)
    corners_.push_back({solid.points[t[0]], solid.points[t[1]], solid.points[t[2]]});
}

void TriangleTree::build() {
  order_.resize(corners_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.clear();
  if (!order_.empty()) build_node(0, static_cast<std::uint32_t>(order_.size()));
}

Eigen::AlignedBox3d TriangleTree::triangle_box(std::uint32_t triangle) const {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : corners_[triangle]) box.extend(p);
  return box;
}

std::uint32_t TriangleTree::build_node(std::uint32_t first, std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = first; i < first + count; ++i) box.extend(triangle_box(order_[i]));
  nodes_[index].box = box;
  nodes_[index].first = first;
  if (count <= leaf_size) {
    nodes_[index].count = count;
    return index;
  }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto begin = order_.begin() + first;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return triangle_box(a).center()[axis] < triangle_box(b).center()[axis];
  });
  build_node(first, half);
  const std::uint32_t second = build_node(first + half, count - half);
  nodes_[index].second = second;
  return index;
}

double TriangleTree::distance(const Vector3d& p, double limit) const {
  double best = limit * limit;
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  if (!nodes_.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (node.box.squaredExteriorDistance(p) >= best) continue;
    if (node.count == 0) {
      const std::uint32_t near = index + 1;
      const bool swap =
          nodes_[near].box.squaredExteriorDistance(p) > nodes_[node.second].box.squaredExteriorDistance(p);
      stack[depth++] = swap ? near : node.second;
      stack[depth++] = swap ? node.second : near;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      best = std::min(best, (nearest_on_triangle(p, corners_[order_[i]]) - p).squaredNorm());
  }
  return std::sqrt(best);
}

std::vector<std::uint32_t> TriangleTree::touching(const Eigen::AlignedBox3d& box) const {
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const std::uint32_t index = stack.back();
    stack.pop_back();
    const Node& node = nodes_[index];
    if (!node.box.intersects(box)) continue;
    if (node.count == 0) {
      stack.push_back(index + 1);
      stack.push_back(node.second);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (triangle_box(order_[i]).intersects(box)) found.push_back(order_[i]);
  }
  return found;
}

}  // namespace fulcrum::content
