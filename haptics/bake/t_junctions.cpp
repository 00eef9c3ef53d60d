#include "haptics/bake/t_junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "haptics/bake/edge_fans.h"

namespace fulcrum {
namespace {

// A cut makes new edges, which may have vertices on them that were a little too far from the old one.
constexpr int kMostPasses = 8;

// Where an open edge is to be cut.
struct Cut {
  std::uint32_t half_edge;  // 3 t + e
  std::uint32_t vertex;
  double along;  // m, from the edge's corner e
};

// The half-edges that have none across, and the vertices at their ends.
struct Boundary {
  std::vector<std::uint32_t> half_edges, vertices;
};

Boundary boundary_of(const TriangleMesh& mesh) {
  Boundary open;
  EdgeFans(mesh.triangles).for_each([&open](std::span<const HalfEdge> fan) {
    const auto forward = static_cast<std::size_t>(
        std::count_if(fan.begin(), fan.end(), [](const HalfEdge& edge) { return edge.forward; }));
    if (2 * forward == fan.size()) return;
    for (const HalfEdge& edge : fan) open.half_edges.push_back(edge.place);
    open.vertices.push_back(fan.front().low);
    open.vertices.push_back(fan.front().high);
  });
  std::sort(open.vertices.begin(), open.vertices.end());
  open.vertices.erase(std::unique(open.vertices.begin(), open.vertices.end()), open.vertices.end());
  return open;
}

// Which vertices lie on which edges: space is halved until few of either are left in it.
class Junctions {
public:
  Junctions(const TriangleMesh& mesh, double width_m) : mesh_(mesh), width_(width_m) {}

  std::vector<Cut> find(Boundary open) {
    Box3 box;
    for (const std::uint32_t v : open.vertices) box.extend(mesh_.vertices[v]);
    look_in(box, std::move(open), 0);
    return std::move(cuts_);
  }

private:
  static constexpr std::size_t kFew = 8;
  static constexpr int kDeepest = 48;  // halvings

  Box3 box_of(std::uint32_t half_edge) const {
    const Triangle& corners = mesh_.triangles[half_edge / 3];
    Box3 box(mesh_.vertices[corners[half_edge % 3]]);
    box.extend(mesh_.vertices[corners[(half_edge % 3 + 1) % 3]]);
    return box;
  }

  void look_in(const Box3& box, Boundary open, int depth) {
    if (open.half_edges.empty() || open.vertices.empty()) return;
    if (open.vertices.size() <= kFew || depth == kDeepest) {
      for (const std::uint32_t h : open.half_edges)
        for (const std::uint32_t v : open.vertices) try_at(h, v);
      return;
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const double middle = box.center()[axis];
    Boundary low, high;
    for (const std::uint32_t v : open.vertices)
      (mesh_.vertices[v][axis] < middle ? low : high).vertices.push_back(v);
    for (const std::uint32_t h : open.half_edges) {
      const Box3 edge = box_of(h);
      if (edge.min()[axis] - width_ < middle) low.half_edges.push_back(h);
      if (edge.max()[axis] + width_ >= middle) high.half_edges.push_back(h);
    }
    open = {};
    Box3 below = box, above = box;
    below.max()[axis] = above.min()[axis] = middle;
    look_in(below, std::move(low), depth + 1);
    look_in(above, std::move(high), depth + 1);
  }

  void try_at(std::uint32_t half_edge, std::uint32_t vertex) {
    const Triangle& corners = mesh_.triangles[half_edge / 3];
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return;
    const Vec3& from = mesh_.vertices[corners[half_edge % 3]];
    const Vec3 way = mesh_.vertices[corners[(half_edge % 3 + 1) % 3]] - from;
    const Vec3 there = mesh_.vertices[vertex] - from;
    const double length = way.norm(), along = there.dot(way) / length;
    if (along > width_ && along < length - width_ && (there - along / length * way).norm() <= width_)
      cuts_.push_back({half_edge, vertex, along});
  }

  const TriangleMesh& mesh_;
  double width_;
  std::vector<Cut> cuts_;
};

// A triangle becomes a fan about the corner across from the edge that is cut.
void cut_along(TriangleMesh& mesh, std::span<const Cut> cuts) {
  const std::uint32_t triangle = cuts.front().half_edge / 3, edge = cuts.front().half_edge % 3;
  const Triangle corners = mesh.triangles[triangle];
  const std::uint32_t to = corners[(edge + 1) % 3], apex = corners[(edge + 2) % 3];
  mesh.triangles[triangle] = {corners[edge], cuts.front().vertex, apex};
  for (std::size_t i = 0; i < cuts.size(); ++i)
    mesh.triangles.push_back({cuts[i].vertex, i + 1 < cuts.size() ? cuts[i + 1].vertex : to, apex});
}

}  // namespace

double least_height(const TriangleMesh& mesh, const Triangle& corner) {
  const Vec3 &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return (b - a).cross(c - a).norm() / longest;
}

Mended drop_slivers(TriangleMesh& mesh, double height_m) {
  Mended mended;
  std::erase_if(mesh.triangles, [&](const Triangle& corners) {
    if (least_height(mesh, corners) > height_m) return false;
    if (mended.count++ == 0) mended.place = mesh.vertices[corners[0]];
    return true;
  });
  return mended;
}

Mended cut_at_t_junctions(TriangleMesh& mesh, double width_m) {
  Mended mended;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    std::vector<Cut> cuts = Junctions(mesh, width_m).find(boundary_of(mesh));
    if (cuts.empty()) break;
    std::sort(cuts.begin(), cuts.end(), [](const Cut& l, const Cut& r) {
      return std::tie(l.half_edge, l.along, l.vertex) < std::tie(r.half_edge, r.along, r.vertex);
    });
    if (mended.count == 0) mended.place = mesh.vertices[cuts.front().vertex];
    // One edge of a triangle is cut in a pass; those of the pieces are in the next.
    std::uint32_t triangle = kNoIndex;
    for (std::size_t begin = 0, end = 0; begin < cuts.size(); begin = end) {
      while (end < cuts.size() && cuts[end].half_edge == cuts[begin].half_edge) ++end;
      if (cuts[begin].half_edge / 3 == triangle) continue;
      triangle = cuts[begin].half_edge / 3;
      cut_along(mesh, std::span(cuts).subspan(begin, end - begin));
      mended.count += end - begin;
    }
  }
  return mended;
}

}  // namespace fulcrum
