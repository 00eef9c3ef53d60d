#include "haptics/bake/winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr std::uint32_t kLeaf = 8;
constexpr double kFar = 2.5;         // radii, beyond which a node is taken as a dipole
constexpr double kUnsure = 0.2;      // off a whole number: then every triangle is asked
constexpr std::size_t kStack = 128;  // 2^32 triangles halve 29 times to a leaf; one sibling waits on each

// A. van Oosterom, J. Strackee, "The solid angle of a plane triangle" (IEEE Trans. Biomed. Eng. 30, 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2.0 * math::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

Winding::Winding(const TriangleMesh& closed) {
  corners_.reserve(closed.triangles.size());
  for (const Triangle& t : closed.triangles)
    corners_.push_back({closed.vertices[t[0]], closed.vertices[t[1]], closed.vertices[t[2]]});
  nodes_.emplace_back();
  nodes_[0].count = static_cast<std::uint32_t>(corners_.size());
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) build(i);
}

void Winding::build(std::uint32_t index) {
  Node& node = nodes_[index];
  const std::span<Corners> own = std::span(corners_).subspan(node.first, node.count);
  Box3 box;
  double whole = 0.0;
  for (const auto& [a, b, c] : own) {
    const Vec3 area = 0.5 * (b - a).cross(c - a);
    node.dipole += area;
    node.centre += area.norm() * (a + b + c) / 3.0;
    whole += area.norm();
    box.extend(a + b + c);
  }
  node.centre = whole > 0.0 ? Vec3(node.centre / whole) : own.front().a;
  for (const auto& [a, b, c] : own) {
    node.radius =
        std::max({node.radius, (a - node.centre).norm(), (b - node.centre).norm(), (c - node.centre).norm()});
  }
  if (node.count <= kLeaf) return;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto key = [axis](const Corners& t) { return t.a[axis] + t.b[axis] + t.c[axis]; };
  const std::uint32_t half = node.count / 2;
  std::nth_element(own.begin(), own.begin() + half, own.end(),
                   [&key](const Corners& l, const Corners& r) { return key(l) < key(r); });
  node.child = static_cast<std::uint32_t>(nodes_.size());
  Node low, high;
  low.first = node.first;
  low.count = half;
  high.first = node.first + half;
  high.count = node.count - half;
  nodes_.push_back(low);
  nodes_.push_back(high);
}

double Winding::sum(const Vec3& p, double far) const {
  double angle = 0.0;
  std::array<std::uint32_t, kStack> stack;
  stack[0] = 0;
  std::size_t top = 1;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    const Vec3 way = node.centre - p;
    const double squared = way.squaredNorm(), reach = far * node.radius;
    if (squared > reach * reach) {
      angle += node.dipole.dot(way) / (squared * std::sqrt(squared));
    } else if (node.child == 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        angle += solid_angle(corners_[i].a - p, corners_[i].b - p, corners_[i].c - p);
    } else {
      stack[top++] = node.child;
      stack[top++] = node.child + 1;
    }
  }
  return angle / (4.0 * std::numbers::pi);
}

int Winding::around(const Vec3& p) const {
  double number = sum(p, kFar);
  if (std::abs(number - std::round(number)) > kUnsure)
    number = sum(p, std::numeric_limits<double>::infinity());
  return static_cast<int>(std::lround(number));
}

}  // namespace fulcrum
