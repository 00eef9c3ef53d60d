#pragma once
// Which patches part nothing from nothing: walls inside a body, fins on its surface.

#include "haptics/bake/patch_visibility.h"
#include "haptics/bake/patches.h"

namespace fulcrum {

// A patch is redundant if the others fit together better without it: where it meets them, more edges then
// have as many triangles along as against, and none fewer. Those whose two sides see alike go first, and each
// that goes may make the next one needed. One answer for each patch.
std::vector<bool> redundant_patches(const TriangleMesh& mesh, const std::vector<Patch>& patches,
                                    const std::vector<PatchVisibility>& visibility);

}  // namespace fulcrum
