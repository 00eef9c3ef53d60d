#include "haptics/bake/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "haptics/bake/surfaces.h"
#include "haptics/bake/winding.h"

namespace fulcrum {
namespace {

// How far b's corners are off a's plane; within `depth` is on it.
std::array<double, 3> heights(const Corners3& a, const Vec3& unit_normal, const Corners3& b, double depth) {
  std::array<double, 3> height{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double h = unit_normal.dot(b[i] - a[0]);
    height[i] = std::abs(h) <= depth ? 0.0 : h;
  }
  return height;
}

bool on_both_sides(const std::array<double, 3>& height) {
  return std::min({height[0], height[1], height[2]}) < 0.0 &&
         std::max({height[0], height[1], height[2]}) > 0.0;
}

bool on_one_side(const std::array<double, 3>& height) {
  return std::min({height[0], height[1], height[2]}) > 0.0 ||
         std::max({height[0], height[1], height[2]}) < 0.0;
}

bool on_the_plane(const std::array<double, 3>& height) {
  return height[0] == 0.0 && height[1] == 0.0 && height[2] == 0.0;
}

// Where a triangle meets a plane that is not its own, measured along the line.
std::array<double, 2> span_on(const Vec3& line, const Vec3& origin, const Corners3& corner,
                              const std::array<double, 3>& height) {
  double from = std::numeric_limits<double>::infinity(), to = -from;
  const auto take = [&](const Vec3& p) {
    from = std::min(from, line.dot(p - origin));
    to = std::max(to, line.dot(p - origin));
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] == 0.0) take(corner[i]);
    if (height[i] * height[j] < 0.0)
      take(corner[i] + height[i] / (height[i] - height[j]) * (corner[j] - corner[i]));
  }
  return {from, to};
}

Vec3 unit_normal(const Corners3& c) {
  return (c[1] - c[0]).cross(c[2] - c[0]).stableNormalized();
}

}  // namespace

Corners3 corners_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const Triangle& corner = mesh.triangles[triangle];
  return {mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]]};
}

Meeting meeting(const Corners3& a, const Corners3& b, double depth) {
  const Vec3 na = unit_normal(a);
  const std::array<double, 3> above_a = heights(a, na, b, depth);
  if (on_one_side(above_a)) return Meeting::apart;
  const Vec3 nb = unit_normal(b);
  const std::array<double, 3> above_b = heights(b, nb, a, depth);
  if (on_one_side(above_b)) return Meeting::apart;
  if (on_the_plane(above_a) || on_the_plane(above_b))
    return overlap(a, b, depth) ? Meeting::touching : Meeting::apart;
  const Vec3 line = na.cross(nb).stableNormalized();
  const std::array<double, 2> in_a = span_on(line, a[0], a, above_b), in_b = span_on(line, a[0], b, above_a);
  const double shared = std::min(in_a[1], in_b[1]) - std::max(in_a[0], in_b[0]);
  if (shared < -depth) return Meeting::apart;
  if (shared <= depth) return Meeting::touching;
  return on_both_sides(above_a) && on_both_sides(above_b) ? Meeting::crossing : Meeting::abutting;
}

bool overlap(const Corners3& a, const Corners3& b, double depth) {
  const Vec3 na = unit_normal(a), nb = unit_normal(b);
  if (!on_the_plane(heights(a, na, b, depth)) || !on_the_plane(heights(b, nb, a, depth))) return false;
  for (const Corners3* own : {&a, &b}) {
    for (std::size_t e = 0; e < 3; ++e) {  // an edge that has the two on its two sides
      const Vec3 out = ((*own)[(e + 1) % 3] - (*own)[e]).cross(own == &a ? na : nb).stableNormalized();
      const auto farthest = [&](const Corners3& c, double sign) {
        return std::max({sign * out.dot(c[0] - (*own)[e]), sign * out.dot(c[1] - (*own)[e]),
                         sign * out.dot(c[2] - (*own)[e])});
      };
      const Corners3& other = own == &a ? b : a;
      if (-farthest(other, -1.0) >= -depth) return false;
    }
  }
  return true;
}

namespace {

bool share_a_corner(const Triangle& a, const Triangle& b) {
  return std::any_of(
      a.begin(), a.end(), [&b](std::uint32_t v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

// Whether the surface winds around both sides of a triangle, or around neither.
bool is_swallowed(const Corners3& c, const Winding& winding, double depth) {
  const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0, beside = depth * unit_normal(c);
  return (winding.around(middle + beside) > 0) == (winding.around(middle - beside) > 0);
}

}  // namespace

std::optional<std::uint32_t> find_crossing(const Solid& solid, std::uint32_t component,
                                           const TriangleTree& tree, double depth) {
  const SolidComponent& own = solid.components[component];
  std::vector<std::uint32_t> near, touching;
  for (std::uint32_t t = own.first_triangle; t < own.first_triangle + own.triangle_count; ++t) {
    const Corners3 corners = corners_of(solid.mesh, t);
    Box3 box(corners[0]);
    box.extend(corners[1]).extend(corners[2]);
    near.clear();
    tree.near_box(tree.of_component(component), box, near);
    for (const std::uint32_t other : near) {
      if (other <= t) continue;
      const Meeting found = meeting(corners, corners_of(solid.mesh, other), depth);
      if (found == Meeting::crossing) return t;
      if (found == Meeting::touching &&
          !share_a_corner(solid.mesh.triangles[t], solid.mesh.triangles[other])) {
        touching.push_back(t);
        touching.push_back(other);
      }
    }
  }
  if (touching.empty()) return std::nullopt;
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  const Winding winding(own_triangles(solid.mesh, own));
  for (const std::uint32_t t : touching)
    if (is_swallowed(corners_of(solid.mesh, t), winding, depth)) return t;
  return std::nullopt;
}

}  // namespace fulcrum
