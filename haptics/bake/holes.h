#pragma once
// The holes of an oriented soup: where its boundary runs, and triangles that close it.

#include "haptics/bake/edge_fans.h"

namespace fulcrum {

struct HoleFill {
  std::vector<std::uint32_t> rim;   // vertices, in order
  std::vector<Triangle> triangles;  // as many as the rim has vertices, less two
  double width_m = 0.0;             // the largest of their least heights; 0 of a crack
  Vec3 place = Vec3::Zero();        // (3) m, the middle of the rim
};

// The soup and all fills together have no boundary: as many triangles run along every edge as against it, so
// that winding numbers are whole everywhere. A rim runs once through each of its vertices; it is closed ear
// by ear (G. H. Meisters, "Polygons have ears", 1975), seen along its own normal, the shortest diagonal
// first.
std::vector<HoleFill> fill_holes(const TriangleMesh& mesh);

}  // namespace fulcrum
