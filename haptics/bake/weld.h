#pragma once
// From a file's triangles to a soup whose triangles know each other by their vertices.

#include <cstdint>
#include <optional>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/result.h"

namespace fulcrum {

// What no welding can help: no triangles or too many, indices out of range, vertices that are not finite.
std::optional<Error> check_numbers(const TriangleMesh& soup);

// Vertices at equal positions become one; triangles with two corners in one place are dropped and counted.
TriangleMesh weld(const TriangleMesh& soup, std::uint32_t& dropped);

// Joins vertices at open edges that lie within `width_m` of each other, as exporters that tessellate face by
// face leave them, and drops the triangles that collapse. Answers how many vertices moved.
std::size_t close_cracks(TriangleMesh& mesh, double width_m);

// Disjoint sets of the numbers below n; the lowest of each stands for it.
class Sets {
public:
  explicit Sets(std::size_t n);
  std::uint32_t find(std::uint32_t i);
  void join(std::uint32_t i, std::uint32_t j);

private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace fulcrum
