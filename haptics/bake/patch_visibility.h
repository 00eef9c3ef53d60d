#pragma once
// How much of its surroundings each side of a patch sees: what tells outside from inside where nothing is
// closed.

#include "haptics/bake/patches.h"

namespace fulcrum {

struct PatchVisibility {
  double front = 0.0;  // the share of rays off the outer side that leave the body
  double back = 0.0;   // the same of the inner side
};

// A body is what hangs together by its edges; only its own triangles stop a ray. One answer for each patch.
std::vector<PatchVisibility> measure_visibility(const TriangleMesh& mesh, const std::vector<Patch>& patches);

}  // namespace fulcrum
