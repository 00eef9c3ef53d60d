#pragma once
// A solid: closed surfaces that bound something, checked once so that nothing later has to doubt it.

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/result.h"

namespace fulcrum {

// One closed, consistently wound surface, with those of its cavities; its triangles are contiguous in
// Solid::mesh.
struct SolidComponent {
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  Box3 bounds;             // m
  double volume_m3 = 0.0;  // > 0
  // Closed triangles that decide by their winding number what is inside, where the component's own cannot: of
  // a surface that crosses itself those are only what bounds it, and slivers have no normal to go by. Empty:
  // the component's own triangles tell, by their normals.
  TriangleMesh shell;
};

// The union of its components, which may overlap.
struct Solid {
  static constexpr std::uint32_t kNoNeighbour = 0xffffffffu;

  TriangleMesh mesh;  // welded; surfaces that only touch have vertices of their own
  // (m x 3) the triangle across edge e, which runs from corner e to corner e+1; kNoNeighbour only in
  // components with a shell
  std::vector<Triangle> neighbours;
  std::vector<SolidComponent> components;
  std::uint32_t dropped_triangles = 0;  // two corners in one place
  std::vector<std::string> notes;       // sentences: what was repaired, and where inside had to be guessed

  Box3 bounds() const;
};

// Welds vertices at equal positions, pairs edges, and checks each connected surface. An edge that 2n
// triangles share, n each way, is n edges of surfaces that touch there. What does not close is repaired
// (haptics/bake/repair.h); a surface inside out is a cavity of the component that holds it, or is turned; one
// that crosses itself is cut back to the boundary of what it winds around. Refused, with numbers, a place and
// a remedy: no triangles, indices out of range, vertices that are not finite, surfaces without volume or with
// one side, sheets, wide holes.
Result<Solid> build_solid(const TriangleMesh& soup);

}  // namespace fulcrum
