#pragma once
// A closed surface as its vertices, edges and faces, each with what lies around it: what exact contact is
// measured on. The frame is the mesh's own.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/feature_tree.h"
#include "haptics/geometry/normal_cone.h"
#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

class FeatureMesh {
public:
  struct Edge {
    std::uint32_t from = 0, to = 0;        // vertices
    std::array<std::uint32_t, 2> faces{};  // on either side; the same where there is one alone
    // (2 x 3) unit, from the edge along either face.
    std::array<Vec3, 2> across{Vec3::Zero(), Vec3::Zero()};
    bool convex = false;  // the surface bends away from its outside there
    // The surface bends so little there that either side's face lies within kFlat of the other's plane.
    bool flat = false;
    // Bit 0: beyond `from`, bit 1: beyond `to`, its line goes on in the solid or along the surface, and no
    // other edge has it there.
    std::uint8_t goes_on = 0;
    bool concave() const { return !convex && !flat; }
  };
  struct Face {
    Triangle corners{};
    std::array<std::uint32_t, 3> edges{};  // edge e runs between corner e and corner e+1
    Vec3 nhat = Vec3::Zero();              // (3) unit, outward
    Box3 box{};                            // m
    // Bit i: corner i, or edge i, is of this face; each vertex and each edge of the mesh is of one face.
    std::uint8_t own_corners = 0, own_edges = 0;
    // Bit i: beyond corner i, or edge i, the surface rises above this face's plane.
    std::uint8_t rises_at_corners = 0, rises_at_edges = 0;
  };
  static constexpr double kFlat = 1e-7;  // m

  // mesh: closed, two faces at each edge, normals outward. neighbours: as of Solid; an edge that has none
  // counts as flat, and nothing is seen to cross it.
  FeatureMesh(const TriangleMesh& mesh, std::span<const Triangle> neighbours);

  std::span<const Vec3> vertices() const { return vertices_; }
  std::span<const Edge> edges() const { return edges_; }
  std::span<const Face> faces() const { return faces_; }
  // (edges x 3) unit, along a vertex's edges, away from it.
  std::span<const Vec3> around(std::uint32_t vertex) const {
    return std::span(around_).subspan(around_begin_[vertex],
                                      around_begin_[vertex + 1] - around_begin_[vertex]);
  }
  // Outward normals. Of a vertex: of all planes through it that have what is around it on their inner side;
  // none where there is no such plane, or where the surface is flat there or a straight edge passes: what is
  // around touches first. Of an edge: from its one face's to the other's.
  std::span<const NormalCone> vertex_normals() const { return vertex_normals_; }
  std::span<const NormalCone> edge_normals() const { return edge_normals_; }
  // Vertices that have normals, and edges that are convex, alone; a face has those of its vertices and of its
  // edges, too.
  const FeatureTree& vertex_tree() const { return vertex_tree_; }
  const FeatureTree& edge_tree() const { return edge_tree_; }
  const FeatureTree& face_tree() const { return face_tree_; }
  double radius() const { return radius_; }  // m, of the farthest vertex from the frame's origin
  std::size_t bytes() const;

private:
  void pair_edges(std::span<const Triangle> neighbours);
  void find_around();
  using FacesAround = std::vector<std::vector<std::uint32_t>>;  // (vertices)
  FacesAround faces_around() const;
  void find_rises(const FacesAround& faces_around);
  void find_line_ends(const FacesAround& faces_around);
  bool goes_on(const Face& face, unsigned corner, std::span<const std::uint32_t> faces) const;
  bool goes_on(std::uint32_t vertex, const Vec3& direction, std::span<const std::uint32_t> faces,
               double most) const;
  void plant_trees();

  std::vector<Vec3> vertices_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> around_begin_;
  std::vector<Vec3> around_;
  std::vector<NormalCone> vertex_normals_, edge_normals_;
  FeatureTree vertex_tree_, edge_tree_, face_tree_;
  double radius_ = 0;
};

}  // namespace fulcrum
