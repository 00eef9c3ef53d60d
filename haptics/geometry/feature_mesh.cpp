#include "haptics/geometry/feature_mesh.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/point_triangle.h"

namespace fulcrum {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr double kStraight = 1e-6;  // rad, a vertex that stands out by less is none to touch with
constexpr double kSameLine = 0.01;  // rad, of edges that are one, but for the rounding of where it was cut

// Of all planes through a vertex that have these edges (unit) on their inner side: the cube about the vertex,
// each of its sides cut by every edge's plane.
NormalCone normals_behind(std::span<const Vec3> edges) {
  std::vector<Vec3> rays, polygon, kept;
  for (int axis = 0; axis < 3 && !edges.empty(); ++axis) {
    for (const double side : {-1.0, 1.0}) {
      polygon.clear();
      for (const auto& [u, v] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        Vec3 corner;
        corner[axis] = side;
        corner[(axis + 1) % 3] = u;
        corner[(axis + 2) % 3] = v;
        polygon.push_back(corner);
      }
      for (const Vec3& edge : edges) {
        kept.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Vec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
          const double a = edge.dot(from), b = edge.dot(to);
          if (a <= 0) kept.push_back(from);
          if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(from + (to - from) * (a / (a - b)));
        }
        polygon.swap(kept);
      }
      for (const Vec3& ray : polygon) rays.push_back(ray.normalized());
    }
  }
  const NormalCone cone = NormalCone::about(rays);
  const bool stands_out = !cone.none() && std::all_of(edges.begin(), edges.end(), [&](const Vec3& edge) {
    return edge.dot(cone.axis()) < -kStraight;
  });
  return stands_out ? cone : NormalCone();
}

}  // namespace

FeatureMesh::FeatureMesh(const TriangleMesh& mesh, std::span<const Triangle> neighbours)
    : vertices_(mesh.vertices) {
  std::vector<bool> taken(vertices_.size(), false);
  for (const Triangle& corners : mesh.triangles) {
    const Vec3& a = vertices_[corners[0]];
    Face face{.corners = corners,
              .nhat = (vertices_[corners[1]] - a).cross(vertices_[corners[2]] - a).stableNormalized()};
    for (const std::uint32_t v : corners) face.box.extend(vertices_[v]);
    for (unsigned i = 0; i < 3; ++i) {
      if (taken[corners[i]]) continue;
      taken[corners[i]] = true;
      face.own_corners = static_cast<std::uint8_t>(face.own_corners | 1u << i);
      radius_ = std::max(radius_, vertices_[corners[i]].norm());
    }
    faces_.push_back(face);
  }
  pair_edges(neighbours);
  find_around();
  const FacesAround around = faces_around();
  find_rises(around);
  find_line_ends(around);
  plant_trees();
}

void FeatureMesh::pair_edges(std::span<const Triangle> neighbours) {
  std::vector<Triangle> known(faces_.size(), {kNone, kNone, kNone});
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    for (unsigned e = 0; e < 3; ++e) {
      const std::uint32_t from = face.corners[e], to = face.corners[(e + 1) % 3];
      if (known[f][e] != kNone) {
        face.edges[e] = known[f][e];
        continue;
      }
      const Vec3 along = (vertices_[to] - vertices_[from]).stableNormalized();
      Edge edge{.from = from, .to = to, .faces = {f, f}, .flat = true};
      edge.across[0] = edge.across[1] = face.nhat.cross(along);
      const std::uint32_t other = neighbours[f][e];
      if (other < faces_.size()) {
        const Face& there = faces_[other];
        for (unsigned k = 0; k < 3; ++k) {
          if (there.corners[k] != to || there.corners[(k + 1) % 3] != from) continue;
          edge.faces[1] = other;
          edge.across[1] = along.cross(there.nhat);
          known[other][k] = static_cast<std::uint32_t>(edges_.size());
          // How far each side's third corner lies above the other side's face.
          const double here_above = there.nhat.dot(vertices_[face.corners[(e + 2) % 3]] - vertices_[from]);
          const double there_above = face.nhat.dot(vertices_[there.corners[(k + 2) % 3]] - vertices_[from]);
          const double above = std::max(here_above, there_above);
          edge.flat = above < kFlat && std::min(here_above, there_above) > -kFlat;
          edge.convex = !edge.flat && above <= kFlat;
        }
      }
      face.edges[e] = static_cast<std::uint32_t>(edges_.size());
      face.own_edges = static_cast<std::uint8_t>(face.own_edges | 1u << e);
      edges_.push_back(edge);
    }
  }
}

void FeatureMesh::find_around() {
  std::vector<std::vector<Vec3>> around(vertices_.size());
  for (const Edge& edge : edges_) {
    const Vec3 along = (vertices_[edge.to] - vertices_[edge.from]).stableNormalized();
    around[edge.from].push_back(along);
    around[edge.to].push_back(-along);
  }
  for (const auto& of_vertex : around) {
    around_begin_.push_back(static_cast<std::uint32_t>(around_.size()));
    around_.insert(around_.end(), of_vertex.begin(), of_vertex.end());
  }
  around_begin_.push_back(static_cast<std::uint32_t>(around_.size()));
}

void FeatureMesh::find_rises(const FacesAround& faces_around) {
  for (Face& face : faces_) {
    for (unsigned i = 0; i < 3; ++i) {
      // Edge i begins at corner i, and edge i + 2 ends there.
      const Edge &edge = edges_[face.edges[i]], &before = edges_[face.edges[(i + 2) % 3]];
      if (edge.concave()) face.rises_at_edges = static_cast<std::uint8_t>(face.rises_at_edges | 1u << i);
      if (!edge.convex && !before.convex && (edge.concave() || before.concave()) &&
          goes_on(face, i, faces_around[face.corners[i]]))
        face.rises_at_corners = static_cast<std::uint8_t>(face.rises_at_corners | 1u << i);
    }
  }
}

// Whether the plane of a face lies in the solid, or along the surface, all around beyond a corner: in the
// directions from which the corner is the face's nearest place.
bool FeatureMesh::goes_on(const Face& face, unsigned corner, std::span<const std::uint32_t> faces) const {
  const Vec3& p = vertices_[face.corners[corner]];
  const Vec3 u = (vertices_[face.corners[(corner + 1) % 3]] - p).stableNormalized(),
             v = (vertices_[face.corners[(corner + 2) % 3]] - p).stableNormalized();
  const Vec3 beyond = -(u + v).stableNormalized(), beside_u = u.cross(face.nhat),
             beside_v = face.nhat.cross(v);
  for (const Vec3& direction : {beside_u, Vec3((beside_u + beyond).stableNormalized()), beyond,
                                Vec3((beyond + beside_v).stableNormalized()), beside_v})
    if (!goes_on(face.corners[corner], direction, faces, kSameLine)) return false;
  return true;
}

FeatureMesh::FacesAround FeatureMesh::faces_around() const {
  FacesAround around(vertices_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    for (const std::uint32_t v : faces_[f].corners) around[v].push_back(f);
  return around;
}

void FeatureMesh::find_line_ends(const FacesAround& faces_around) {
  std::vector<std::vector<Vec3>> convex_around(vertices_.size());  // unit, away from the vertex
  for (const Edge& edge : edges_) {
    if (!edge.convex) continue;
    const Vec3 along = (vertices_[edge.to] - vertices_[edge.from]).stableNormalized();
    convex_around[edge.from].push_back(along);
    convex_around[edge.to].push_back(-along);
  }
  // Where the next edge of the same line begins, the line is that one's.
  const auto is_continued = [&](std::uint32_t vertex, const Vec3& along) {
    return std::any_of(convex_around[vertex].begin(), convex_around[vertex].end(),
                       [&](const Vec3& next) { return (next - along).norm() < kSameLine; });
  };
  for (Edge& edge : edges_) {
    if (!edge.convex) continue;
    const Vec3 along = (vertices_[edge.to] - vertices_[edge.from]).stableNormalized();
    if (!is_continued(edge.from, -along) && goes_on(edge.from, -along, faces_around[edge.from], kStraight))
      edge.goes_on |= 1u;
    if (!is_continued(edge.to, along) && goes_on(edge.to, along, faces_around[edge.to], kStraight))
      edge.goes_on |= 2u;
  }
}

// The face nearest to a place beside the vertex tells on which side of the surface the place is; where
// several are as near, since an edge or the vertex itself is nearest, the one whose plane is farthest from it
// does. most: rad, above the surface.
bool FeatureMesh::goes_on(std::uint32_t vertex, const Vec3& direction, std::span<const std::uint32_t> faces,
                          double most) const {
  // The place is 1 away, and the faces are taken as far larger: how long their edges are makes no difference.
  double nearest = 2, facing = 0;
  for (const std::uint32_t f : faces) {
    const Triangle& corners = faces_[f].corners;
    const auto at =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
    const Vec3 u = (vertices_[corners[(at + 1) % 3]] - vertices_[vertex]).stableNormalized(),
               v = (vertices_[corners[(at + 2) % 3]] - vertices_[vertex]).stableNormalized();
    const double distance = std::sqrt(closest_on_triangle(direction, Vec3::Zero(), 4 * u, 4 * v).squared);
    const double height = faces_[f].nhat.dot(direction);
    if (distance > nearest + kStraight) continue;
    if (distance < nearest - kStraight || std::abs(height) > std::abs(facing)) facing = height;
    nearest = std::min(nearest, distance);
  }
  return facing < most;
}

void FeatureMesh::plant_trees() {
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) vertex_normals_.push_back(normals_behind(around(v)));
  std::vector<TreeFeature> vertices, edges, faces;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (!vertex_normals_[v].none())
      vertices.push_back({v, Box3(vertices_[v], vertices_[v]), vertex_normals_[v]});
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const Edge& edge = edges_[e];
    edge_normals_.push_back(
        NormalCone::about(std::array{faces_[edge.faces[0]].nhat, faces_[edge.faces[1]].nhat}));
    if (!edge.convex) continue;
    Box3 box(vertices_[edge.from], vertices_[edge.from]);
    box.extend(vertices_[edge.to]);
    edges.push_back({e, box, edge_normals_[e]});
  }
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    NormalCone cone(faces_[f].nhat);
    for (unsigned i = 0; i < 3; ++i) {
      const Edge& edge = edges_[faces_[f].edges[i]];
      if (edge.convex || edge.flat) cone = NormalCone::about(cone, edge_normals_[faces_[f].edges[i]]);
      cone = NormalCone::about(cone, vertex_normals_[faces_[f].corners[i]]);
    }
    faces.push_back({f, faces_[f].box, cone});
  }
  vertex_tree_ = FeatureTree(std::move(vertices));
  edge_tree_ = FeatureTree(std::move(edges));
  face_tree_ = FeatureTree(std::move(faces));
}

std::size_t FeatureMesh::bytes() const {
  return vertices_.size() * sizeof(Vec3) + edges_.size() * sizeof(Edge) + faces_.size() * sizeof(Face) +
         (vertex_normals_.size() + edge_normals_.size()) * sizeof(NormalCone) + vertex_tree_.bytes() +
         edge_tree_.bytes() + face_tree_.bytes() + around_.size() * sizeof(Vec3) +
         around_begin_.size() * sizeof(std::uint32_t);
}

}  // namespace fulcrum
