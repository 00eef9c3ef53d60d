#pragma once
// What of a surface that crosses itself is the boundary of the space it winds around.

#include <cstdint>

#include "haptics/bake/crossings.h"
#include "haptics/bake/winding.h"

namespace fulcrum {

struct OuterBoundary {
  TriangleMesh mesh;        // welded, wound outwards; ends where triangles cross, where its edges may be open
  bool inside_out = false;  // somewhere the surface winds around a place the wrong way: taken as outside
  Vec3 inside_out_at = Vec3::Zero();  // (3) m, there
};

// Every triangle is cut along those that cross it, and a piece is kept where the winding number is positive
// on one side and not on the other. Pieces narrower than 1e-9 of the diagonal are left out.
OuterBoundary outer_boundary(const Solid& solid, std::uint32_t component, const TriangleTree& tree,
                             const Winding& winding);

}  // namespace fulcrum
