#include "haptics/bake/sharp_features.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

// A blade without thickness has no outside to point to: up, so that a normal is a normal.
Vec3 unit(const Vec3& v) {
  return v.squaredNorm() > 0.0 ? Vec3(v.stableNormalized()) : Vec3(Vec3::UnitY());
}

class SharpEdges {
public:
  SharpEdges(const Solid& solid, double angle, SharpEdgeKind kind)
      : positions_(solid.mesh.vertices), angle_(angle) {
    // Faces that make the mesh non-manifold are left out: where a surface that crossed itself was cut.
    omerr().disable();
    for (std::size_t i = 0; i < positions_.size(); ++i) mesh_.add_vertex();
    for (const Triangle& corner : solid.mesh.triangles) {
      const auto vertex = [&corner](std::size_t i) {
        return OpenMesh::VertexHandle(static_cast<int>(corner[i]));
      };
      if (!mesh_.add_face(vertex(0), vertex(1), vertex(2)).is_valid()) continue;
      const Vec3& a = positions_[corner[0]];
      normals_.push_back((positions_[corner[1]] - a).cross(positions_[corner[2]] - a).stableNormalized());
    }
    walked_.assign(mesh_.n_edges(), false);
    for (const auto edge : mesh_.edges()) {
      sharp_.push_back(!edge.is_boundary() &&
                       angle_between(normal(edge.h0().face()), normal(edge.h1().face())) > angle_ &&
                       (kind == SharpEdgeKind::any || is_convex(edge.h0())));
    }
  }

  std::vector<SurfacePoint> sample(double spacing) {
    std::vector<SurfacePoint> points;
    for (const auto vertex : mesh_.vertices())
      if (is_corner(vertex)) points.push_back(at_vertex(vertex));
    for (const auto vertex : mesh_.vertices()) {
      if (!is_corner(vertex)) continue;
      for (const auto edge : vertex.outgoing_halfedges()) walk(edge, spacing, points);
    }
    for (const auto edge : mesh_.halfedges()) {  // what is left are closed loops without a corner
      if (sharp_[index(edge.edge())] && !walked_[index(edge.edge())]) {
        points.push_back(at_vertex(edge.from()));
        walk(edge, spacing, points);
      }
    }
    return points;
  }

private:
  using Halfedge = OpenMesh::SmartHalfedgeHandle;
  using Vertex = OpenMesh::SmartVertexHandle;

  static std::size_t index(const OpenMesh::EdgeHandle& edge) { return static_cast<std::size_t>(edge.idx()); }
  Vec3 position(const Vertex& vertex) const { return positions_[static_cast<std::size_t>(vertex.idx())]; }
  Vec3 normal(const OpenMesh::FaceHandle& face) const {
    return normals_[static_cast<std::size_t>(face.idx())];
  }
  Vec3 along(const Halfedge& edge) const {
    return (position(edge.to()) - position(edge.from())).normalized();
  }

  bool is_convex(const Halfedge& edge) const {
    const Vec3 across = position(edge.opp().next().to()) - position(edge.to());
    return normal(edge.face()).dot(across) < 0.0;
  }

  // Where sharp edges end, meet, or turn.
  bool is_corner(const Vertex& vertex) const {
    std::vector<Vec3> directions;
    for (const auto edge : vertex.outgoing_halfedges())
      if (sharp_[index(edge.edge())]) directions.push_back(along(edge));
    if (directions.size() != 2) return !directions.empty();
    return -directions[0].dot(directions[1]) < math::cos(angle_);
  }

  SurfacePoint at_vertex(const Vertex& vertex) const {
    Vec3 sum = Vec3::Zero();
    for (const auto corner : vertex.outgoing_halfedges()) {
      if (corner.is_boundary()) continue;
      sum += normal(corner.face()) * angle_between(along(corner), -along(corner.prev()));
    }
    return {position(vertex), unit(sum)};
  }

  Vec3 edge_normal(const Halfedge& edge) const {
    return unit(normal(edge.face()) + normal(edge.opp().face()));
  }

  // From the start of a sharp edge to the next corner, or around a loop; points evenly between the ends.
  void walk(Halfedge edge, double spacing, std::vector<SurfacePoint>& points) {
    std::vector<Halfedge> chain;
    double length = 0.0;
    while (sharp_[index(edge.edge())] && !walked_[index(edge.edge())]) {
      walked_[index(edge.edge())] = true;
      chain.push_back(edge);
      length += (position(edge.to()) - position(edge.from())).norm();
      if (is_corner(edge.to())) break;
      edge = next_sharp(edge);
    }
    const double step = length / std::max(1.0, std::ceil(length / spacing));
    double passed = 0.0, next = step;
    for (const Halfedge& link : chain) {
      const double link_length = (position(link.to()) - position(link.from())).norm();
      for (; next <= passed + link_length && next < length - 0.5 * step; next += step)
        points.push_back({position(link.from()) + (next - passed) * along(link), edge_normal(link)});
      passed += link_length;
    }
  }

  // The other sharp edge at the end of this one; the end is no corner, so there is exactly one.
  Halfedge next_sharp(const Halfedge& edge) const {
    for (const auto candidate : edge.to().outgoing_halfedges())
      if (sharp_[index(candidate.edge())] && candidate.edge() != edge.edge()) return candidate;
    return edge;
  }

  OpenMesh::TriConnectivity mesh_;
  std::vector<Vec3> positions_;  // (vertices x 3) m
  std::vector<Vec3> normals_;    // (faces x 3) unit; zero for a triangle without area
  double angle_;
  std::vector<bool> sharp_, walked_;  // (edges)
};

}  // namespace

std::vector<SurfacePoint> sharp_points(const Solid& solid, double sharp_angle_rad, double spacing_m,
                                       SharpEdgeKind kind) {
  return SharpEdges(solid, sharp_angle_rad, kind).sample(spacing_m);
}

}  // namespace fulcrum
