#pragma once
// Workspace walls, as the trace and the digest see them.

#include "haptics/math/linear.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What one tick leaves behind.
struct WorkspaceWallsRecord {
  double depth = 0;             // m, of the handle in the walls; 0: inside of them
  Vec3 force_D = Vec3::Zero();  // (3) N on the handle, before safety
};

template <class V>
void describe(V& values, const WorkspaceWallsRecord& record) {
  const auto& [depth, force_D] = record;
  values.number({"workspace_walls/depth", "m", "", "Of the handle in the walls of its workspace; 0: within."},
                depth);
  values.vector({"workspace_walls/force", "N", "D", "Of those walls on the handle, before safety."}, force_D);
}

}  // namespace fulcrum
