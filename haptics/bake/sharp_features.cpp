#include "haptics/bake/sharp_features.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Normal);
  FaceAttributes(OpenMesh::Attributes::Normal);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

Vec3 eigen(const OpenMesh::Vec3d& v) {
  return {v[0], v[1], v[2]};
}

Mesh to_openmesh(const Solid& solid) {
  Mesh mesh;
  std::vector<OpenMesh::VertexHandle> vertices;
  vertices.reserve(solid.mesh.vertices.size());
  for (const Vec3& p : solid.mesh.vertices) vertices.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const Triangle& corner : solid.mesh.triangles) {
    mesh.add_face(vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]);
  }
  mesh.update_face_normals();
  return mesh;
}

class SharpEdges {
public:
  SharpEdges(const Solid& solid, double angle)
      : mesh_(to_openmesh(solid)),
        angle_(angle),
        sharp_(mesh_.n_edges(), false),
        walked_(mesh_.n_edges(), false) {
    for (const auto edge : mesh_.edges()) {
      sharp_[index(edge)] = std::abs(mesh_.calc_dihedral_angle(edge)) > angle_;
    }
  }

  std::vector<SurfacePoint> sample(double spacing) {
    std::vector<SurfacePoint> points;
    for (const auto vertex : mesh_.vertices()) {
      if (is_corner(vertex)) points.push_back(at_vertex(vertex));
    }
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
  Vec3 position(const Vertex& vertex) const { return eigen(mesh_.point(vertex)); }
  Vec3 along(const Halfedge& edge) const {
    return (position(edge.to()) - position(edge.from())).normalized();
  }

  // Where sharp edges end, meet, or turn.
  bool is_corner(const Vertex& vertex) const {
    std::vector<Vec3> directions;
    for (const auto edge : vertex.outgoing_halfedges()) {
      if (sharp_[index(edge.edge())]) directions.push_back(along(edge));
    }
    if (directions.size() != 2) return !directions.empty();
    return -directions[0].dot(directions[1]) < std::cos(angle_);
  }

  SurfacePoint at_vertex(const Vertex& vertex) const {
    Vec3 sum = Vec3::Zero();
    for (const auto corner : vertex.outgoing_halfedges()) {
      if (corner.is_boundary()) continue;
      sum += eigen(mesh_.normal(corner.face())) * mesh_.calc_sector_angle(corner.prev());
    }
    return {position(vertex), sum.stableNormalized()};
  }

  Vec3 edge_normal(const Halfedge& edge) const {
    return (eigen(mesh_.normal(edge.face())) + eigen(mesh_.normal(edge.opp().face()))).stableNormalized();
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
      for (; next <= passed + link_length && next < length - 0.5 * step; next += step) {
        points.push_back({position(link.from()) + (next - passed) * along(link), edge_normal(link)});
      }
      passed += link_length;
    }
  }

  // The other sharp edge at the end of this one; the end is no corner, so there is exactly one.
  Halfedge next_sharp(const Halfedge& edge) const {
    for (const auto candidate : edge.to().outgoing_halfedges()) {
      if (sharp_[index(candidate.edge())] && candidate.edge() != edge.edge()) return candidate;
    }
    return edge;
  }

  Mesh mesh_;
  double angle_;
  std::vector<bool> sharp_, walked_;  // (edges)
};

}  // namespace

std::vector<SurfacePoint> sharp_points(const Solid& solid, double sharp_angle_rad, double spacing_m) {
  return SharpEdges(solid, sharp_angle_rad).sample(spacing_m);
}

}  // namespace fulcrum
