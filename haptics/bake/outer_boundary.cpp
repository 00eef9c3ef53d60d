#include "haptics/bake/outer_boundary.h"

#include <algorithm>
#include <cmath>

#include "haptics/bake/parallel.h"
#include "haptics/bake/weld.h"

namespace fulcrum {
namespace {

constexpr double kNothing = 1e-9;  // of the diagonal: a length below it is rounding
constexpr double kBeside = 1e-7;   // of the diagonal, off a piece to look at its sides

using Polygon = std::vector<Vec3>;  // convex, flat

struct Cut {
  Vec3 normal = Vec3::Zero();  // (3) unit
  double offset = 0.0;         // m, normal . p on the plane
  Box3 box;                    // m, of the triangle it comes from: beyond it the plane does not cut
};

Box3 box_of(std::span<const Vec3> points, double grown) {
  Box3 box;
  for (const Vec3& p : points) box.extend(p);
  return {box.min().array() - grown, box.max().array() + grown};
}

// Both parts, if the plane has the polygon on both sides.
bool split(const Polygon& polygon, const Cut& cut, double nothing, Polygon& above, Polygon& below) {
  std::vector<double> height;
  bool any_above = false, any_below = false;
  for (const Vec3& p : polygon) {
    const double h = cut.normal.dot(p) - cut.offset;
    height.push_back(std::abs(h) <= nothing ? 0.0 : h);
    any_above = any_above || height.back() > 0.0;
    any_below = any_below || height.back() < 0.0;
  }
  if (!any_above || !any_below) return false;
  above.clear();
  below.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (height[i] >= 0.0) above.push_back(polygon[i]);
    if (height[i] <= 0.0) below.push_back(polygon[i]);
    if (height[i] * height[j] < 0.0) {
      const Vec3 p = polygon[i] + height[i] / (height[i] - height[j]) * (polygon[j] - polygon[i]);
      above.push_back(p);
      below.push_back(p);
    }
  }
  return true;
}

class Cutter {
public:
  Cutter(const Solid& solid, std::uint32_t component, const TriangleTree& tree, const Winding& winding)
      : solid_(solid),
        tree_(tree),
        root_(tree.of_component(component)),
        winding_(winding),
        diagonal_(solid.components[component].bounds.diagonal().norm()) {}

  struct Kept {
    std::vector<Polygon> pieces;
    bool inside_out = false;
    Vec3 inside_out_at = Vec3::Zero();
  };

  Kept keep(std::uint32_t triangle) const {
    Kept kept;
    const Corners3 corners = corners_of(solid_.mesh, triangle);
    const Vec3 n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
    std::vector<Corners3> over;
    const std::vector<Cut> cuts = cuts_of(triangle, corners, over);
    struct Waiting {
      Polygon polygon;
      std::size_t next;  // cut
    };
    std::vector<Waiting> waiting{{Polygon(corners.begin(), corners.end()), 0}};
    Polygon above, below;
    while (!waiting.empty()) {
      Waiting piece = std::move(waiting.back());
      waiting.pop_back();
      const Box3 box = box_of(piece.polygon, nothing());
      while (piece.next < cuts.size() && !(box.intersects(cuts[piece.next].box) &&
                                           split(piece.polygon, cuts[piece.next], nothing(), above, below)))
        ++piece.next;
      if (piece.next < cuts.size()) {
        waiting.push_back({above, piece.next + 1});
        waiting.push_back({below, piece.next + 1});
      } else {
        judge(std::move(piece.polygon), n, over, kept);
      }
    }
    return kept;
  }

private:
  double nothing() const { return kNothing * diagonal_; }

  // The planes of those that cross it or end on it; of those that lie in its own plane, their edges. `over`:
  // of the latter those that come first, and stand for it where they cover it.
  std::vector<Cut> cuts_of(std::uint32_t triangle, const Corners3& corners,
                           std::vector<Corners3>& over) const {
    std::vector<std::uint32_t> near;
    const Box3 box = box_of(corners, nothing());
    tree_.near_box(root_, box, near);
    std::sort(near.begin(), near.end());
    std::vector<Cut> cuts;
    for (const std::uint32_t other : near) {
      if (other == triangle) continue;
      const Corners3 there = corners_of(solid_.mesh, other);
      const Vec3 n = (there[1] - there[0]).cross(there[2] - there[0]).stableNormalized();
      if (meeting(corners, there, nothing()) >= Meeting::abutting) {
        cuts.push_back({n, n.dot(there[0]), box_of(there, nothing())});
      } else if (overlap(corners, there, nothing())) {
        if (other < triangle) over.push_back(there);
        for (std::size_t e = 0; e < 3; ++e) {
          const Vec3 out = (there[(e + 1) % 3] - there[e]).cross(n).stableNormalized();
          cuts.push_back({out, out.dot(there[e]), box_of(there, nothing())});
        }
      }
    }
    return cuts;
  }

  void judge(Polygon polygon, const Vec3& n, const std::vector<Corners3>& over, Kept& kept) const {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : polygon) centre += p / static_cast<double>(polygon.size());
    double width = diagonal_;  // from the centre to the nearest edge
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      width = std::min(width, (b - a).cross(centre - a).norm() / std::max((b - a).norm(), 1e-300));
    }
    if (!(width > nothing())) return;
    for (const Corners3& c : over)
      if (closest_on_triangle(centre, c[0], c[1], c[2]).squared <= nothing() * nothing()) return;
    const Vec3 beside = std::min(kBeside * diagonal_, 0.1 * width) * n;
    const int front = winding_.around(centre + beside), back = winding_.around(centre - beside);
    if (std::min(front, back) < 0 && !kept.inside_out) {
      kept.inside_out = true;
      kept.inside_out_at = centre;
    }
    if ((front > 0) == (back > 0)) return;
    if (front > 0) std::reverse(polygon.begin(), polygon.end());
    kept.pieces.push_back(std::move(polygon));
  }

  const Solid& solid_;
  const TriangleTree& tree_;
  TriangleTree::Root root_;
  const Winding& winding_;
  double diagonal_;
};

}  // namespace

OuterBoundary outer_boundary(const Solid& solid, std::uint32_t component, const TriangleTree& tree,
                             const Winding& winding) {
  const SolidComponent& own = solid.components[component];
  const Cutter cutter(solid, component, tree, winding);
  std::vector<Cutter::Kept> kept(own.triangle_count);
  for_each_piece(
      kept.size(), 0,
      [&](std::size_t i) { kept[i] = cutter.keep(own.first_triangle + static_cast<std::uint32_t>(i)); }, {});
  OuterBoundary result;
  TriangleMesh pieces;
  for (std::uint32_t i = 0; i < own.triangle_count; ++i) {
    if (kept[i].inside_out && !result.inside_out) {
      result.inside_out = true;
      result.inside_out_at = kept[i].inside_out_at;
    }
    for (const Polygon& piece : kept[i].pieces) {
      const auto first = static_cast<std::uint32_t>(pieces.vertices.size());
      pieces.vertices.insert(pieces.vertices.end(), piece.begin(), piece.end());
      for (std::uint32_t corner = 2; corner < piece.size(); ++corner)
        pieces.triangles.push_back({first, first + corner - 1, first + corner});
    }
  }
  std::uint32_t collapsed = 0;
  result.mesh = weld(pieces, collapsed);
  return result;
}

}  // namespace fulcrum
