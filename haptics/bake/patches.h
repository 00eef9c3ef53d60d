#pragma once
// Patches: what hangs together across edges of just two triangles, whose winding can be made to agree.

#include "haptics/bake/edge_fans.h"
#include "haptics/math/result.h"

namespace fulcrum {

struct Patch {
  std::vector<std::uint32_t> triangles;  // rising
  std::size_t turned = 0;                // of them, how many were wound against the rest
  bool open = false;                     // has an edge of one triangle
  bool joined = false;                   // has an edge of three or more
};

// Turns triangles so that within a patch all are wound as most of its area was.
// Refused: a surface with one side only.
Result<std::vector<Patch>> cut_into_patches(TriangleMesh& mesh);

void turn(Triangle& triangle);  // the other side becomes its outer one

}  // namespace fulcrum
