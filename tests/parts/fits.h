#pragma once
// Pairs of parts that fit into each other, as people export them: a tool, what it fits into, and where.

#include <string>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum::parts {

struct Fit {
  std::string name;
  TriangleMesh tool_T{}, scene_W{};
  Pose X_WT{};                    // in place, with clearance all around
  Vec3 way_W = Vec3::UnitZ();     // (3) unit: where the fit lets it go, or about which it turns
  double pitch = 0;               // m a turn about way_W; 0: it slides
  Vec3 across_W = Vec3::UnitX();  // (3) unit: where the fit holds it
  double clearance = 0;           // m, the smallest on one side
};

// Pegs and holes H7/g6 (ISO 286-2), threads M4 to M20, gears, a hinge, combs, a key in a lock.
std::vector<Fit> fits();

}  // namespace fulcrum::parts
