#pragma once
// Triangles as files give them: a soup. Nothing is promised about closedness, winding or shared vertices.

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum {

using Box3 = Eigen::AlignedBox3d;  // axis-aligned; default-constructed it is empty
using Triangle = std::array<std::uint32_t, 3>;

struct TriangleMesh {
  std::vector<Vec3> vertices;       // (n x 3) m
  std::vector<Triangle> triangles;  // (m x 3) indices into vertices; counter-clockwise seen from outside
};

}  // namespace fulcrum
