#pragma once
// A closed surface as its vertices, edges and faces, each with what lies around it: what exact contact is
// measured on. The frame is the mesh's own.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

class FeatureMesh {
public:
  struct Edge {
    std::uint32_t from = 0, to = 0;           // vertices
    std::array<std::uint32_t, 2> opposite{};  // (2) vertices: the third corner of the face on either side
    bool convex = false;                      // the surface bends away from its outside there
    // The surface bends so little there that either side's face lies within kFlat of the other's plane.
    bool flat = false;
  };
  struct Face {
    Triangle corners{};
    std::array<std::uint32_t, 3> edges{};  // edge e runs between corner e and corner e+1
    Vec3 nhat = Vec3::Zero();              // (3) unit, outward
    Box3 box{};                            // m
    // Bit i: corner i, or edge i, is of this face; each vertex and each edge of the mesh is of one face.
    std::uint8_t own_corners = 0, own_edges = 0;
  };
  // Of a tree over the faces: an inner node's children are `first` and `first + 1`.
  struct Node {
    Box3 box;  // m
    Vec3 centre = Vec3::Zero();
    double radius = 0;        // m, about the box's centre
    std::uint32_t first = 0;  // child, or face in order()
    std::uint32_t count = 0;  // faces of a leaf; 0: an inner node
  };
  static constexpr double kFlat = 1e-7;  // m

  // mesh: closed, two faces at each edge, normals outward. neighbours: as of Solid; an edge that has none
  // counts as flat, and nothing is seen to cross it.
  FeatureMesh(const TriangleMesh& mesh, std::span<const Triangle> neighbours);

  std::span<const Vec3> vertices() const { return vertices_; }
  std::span<const Edge> edges() const { return edges_; }
  std::span<const Face> faces() const { return faces_; }
  std::span<const std::uint32_t> around(std::uint32_t vertex) const {  // its neighbours, along the edges
    return std::span(around_).subspan(around_begin_[vertex],
                                      around_begin_[vertex + 1] - around_begin_[vertex]);
  }
  std::span<const Node> nodes() const { return nodes_; }
  std::span<const std::uint32_t> order() const { return order_; }
  double radius() const { return radius_; }  // m, of the farthest vertex from the frame's origin
  std::size_t bytes() const;

private:
  void pair_edges(std::span<const Triangle> neighbours);
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);

  std::vector<Vec3> vertices_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> around_begin_, around_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  double radius_ = 0;
};

}  // namespace fulcrum
