// Segments and boxes against triangles. The edge tests use triple products about the segment's start: for two
// triangles that share an edge they are each other's exact negation, so that no segment passes between them
// (the idea of S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013, without
// its shear). Around a vertex rounding could still turn every triangle of the fan away; so each reaches
// beyond its edges by that rounding.

#include <algorithm>
#include <array>
#include <limits>

#include "haptics/bake/triangle_tree.h"

namespace fulcrum {
namespace {

constexpr double kProductSlack = 1e-15;   // of a triple product, relative to the lengths in it
constexpr double kFractionSlack = 1e-12;  // consecutive segments share an end: neither may miss a hit there

// The fraction at which the segment meets the triangle's plane inside the triangle.
std::optional<double> meet(const Vec3& p0, const Vec3& along, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 A = a - p0, B = b - p0, C = c - p0;
  const double u = along.dot(C.cross(B)), v = along.dot(A.cross(C)), w = along.dot(B.cross(A));
  const double slack =
      kProductSlack * along.norm() * std::max({A.squaredNorm(), B.squaredNorm(), C.squaredNorm()});
  const bool any_below = std::min({u, v, w}) < -slack;
  const bool any_above = std::max({u, v, w}) > slack;
  if (any_below == any_above) return std::nullopt;  // on different sides, or in the plane
  const Vec3 n = (B - A).cross(C - A);
  const double slope = n.dot(along);
  if (slope == 0.0) return std::nullopt;
  const double fraction = n.dot(A) / slope;
  if (!(fraction >= -kFractionSlack && fraction <= 1.0 + kFractionSlack)) return std::nullopt;
  return std::clamp(fraction, 0.0, 1.0);
}

}  // namespace

std::optional<TriangleTree::Hit> TriangleTree::first_hit(Root root, const Vec3& p0, const Vec3& p1) const {
  const Vec3 along = p1 - p0;
  const Vec3 start = p0 - centre_;
  std::optional<Hit> first;
  double limit = 1.0 + kFractionSlack;

  // How far along the segment the box begins; above `limit` if it is missed.
  const auto enters_box = [&](const Node& node, Eigen::Index i) {
    double from = -kFractionSlack, to = limit;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double low = static_cast<double>(node.low[a][i]) - start[axis];
      const double high = static_cast<double>(node.high[a][i]) - start[axis];
      if (along[axis] == 0.0) {
        if (low > 0.0 || high < 0.0) return std::numeric_limits<double>::infinity();
        continue;
      }
      const double s = low / along[axis], e = high / along[axis];
      from = std::max(from, std::min(s, e));
      to = std::min(to, std::max(s, e));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  };

  std::array<Root, kStack> stack;
  stack[0] = root;
  std::size_t top = 1;
  while (top > 0) {
    const Root next = stack[--top];
    if (is_leaf(next)) {
      const std::uint32_t begin = kLeafTriangles * leaf_index(next);
      for (std::uint32_t i = begin; i < begin + leaf_count(next); ++i) {
        const Corners& corners = corners_[i];
        const std::optional<double> fraction = meet(p0, along, corners.a, corners.b, corners.c);
        if (!fraction || *fraction > limit) continue;
        if (first && *fraction == first->fraction && corners.triangle > first->triangle) continue;
        first = Hit{corners.triangle, *fraction};
        limit = *fraction;
      }
      continue;
    }
    const Node& node = nodes_[next];
    for (std::size_t i = 0; i < 4; ++i)
      if (node.child[i] != kNone && enters_box(node, static_cast<Eigen::Index>(i)) <= limit)
        stack[top++] = node.child[i];
  }
  return first;
}

void TriangleTree::near_box(Root root, const Box3& box, std::vector<std::uint32_t>& found) const {
  const Eigen::Vector3f low = (box.min() - centre_).cast<float>(), high = (box.max() - centre_).cast<float>();
  std::array<Root, kStack> stack;
  stack[0] = root;
  std::size_t top = 1;
  while (top > 0) {
    const Root next = stack[--top];
    if (is_leaf(next)) {
      const std::uint32_t begin = kLeafTriangles * leaf_index(next);
      for (std::uint32_t i = begin; i < begin + leaf_count(next); ++i) found.push_back(corners_[i].triangle);
      continue;
    }
    const Node& node = nodes_[next];
    Eigen::Array<bool, 4, 1> meets = Eigen::Array<bool, 4, 1>::Constant(true);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      meets = meets && node.low[axis] <= high[a] && node.high[axis] >= low[a];
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (meets[static_cast<Eigen::Index>(i)] && node.child[i] != kNone) stack[top++] = node.child[i];
  }
}

}  // namespace fulcrum
