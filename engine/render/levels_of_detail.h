#pragma once
// The triangles of a large mesh once more, in pieces that are each seen or not, and fewer of them for who is
// far away.
//
// Edges are collapsed in the order of quadric errors: M. Garland and P. Heckbert, "Surface simplification
// using quadric error metrics" (SIGGRAPH 1997); those of normals and colours as in H. Hoppe, "New quadric
// metric for simplifying meshes with appearance attributes" (IEEE Visualization 1999). Places in textures are
// told in metres, by which a texture slides over the surface.

#include <array>
#include <cstdint>
#include <vector>

#include "engine/render/bounds.h"

namespace fulcrum::render {

struct Mesh;

struct LevelsOfDetail {
  struct Level {
    std::uint32_t first = 0;  // into indices
    std::uint32_t count = 0;
    // m, root mean square; the worst place is off by less than twice as much. It is hardly to be told from
    // the finest where that is less than about half a pixel: as far as it is from that in place, as far as
    // textures have slid, and where normals or colours differ, the side of a square on which a large
    // difference is as much.
    float error = 0.0F;
  };
  struct Piece {
    Bounds bounds;              // m, mesh frame
    std::vector<Level> levels;  // the finest first: all triangles, without error
  };

  // Into the mesh's vertices: coarser levels have none of their own. All of the finest come first: the whole
  // mesh, in another order.
  std::vector<std::uint32_t> indices;
  std::vector<Piece> pieces;  // together the whole mesh; levels of neighbours meet without a gap
};

// Below this a mesh is drawn as it is.
inline constexpr std::size_t kTrianglesWorthLevels = 200;

// Which of a mesh's places in textures are looked up: the others may go anywhere.
using UvSets = std::array<bool, 2>;

// The same for the same mesh, however many cores there are.
LevelsOfDetail levels_of_detail(const Mesh& mesh, const UvSets& read = {true, true});

}  // namespace fulcrum::render
