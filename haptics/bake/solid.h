#pragma once
// A solid: closed surfaces that bound something, checked once so that nothing later has to doubt it.

#include <cstdint>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/result.h"

namespace fulcrum {

// One closed, consistently wound 2-manifold surface; its triangles are contiguous in Solid::mesh.
struct SolidComponent {
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  Box3 bounds;             // m
  double volume_m3 = 0.0;  // > 0
};

// The union of its components, which may overlap.
struct Solid {
  TriangleMesh mesh;  // welded; surfaces that only touch have vertices of their own
  // (m x 3) the triangle across edge e, which runs from corner e to corner e+1
  std::vector<Triangle> neighbours;
  std::vector<SolidComponent> components;
  std::uint32_t dropped_triangles = 0;  // two corners in one place

  Box3 bounds() const;
};

// Welds vertices at equal positions, pairs edges, and checks each connected surface. An edge that 2n
// triangles share, n each way, is n edges of surfaces that touch there. Refused, with numbers, a place and a
// remedy: no triangles, indices out of range, vertices that are not finite, holes, edges that cannot be
// paired, surfaces wound inside out or inconsistently, surfaces without volume.
Result<Solid> build_solid(const TriangleMesh& soup);

}  // namespace fulcrum
