#pragma once
// From a file's triangles to a soup whose triangles know each other by their vertices.

#include <cstdint>
#include <optional>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/result.h"

namespace fulcrum {

// What no welding can help: no triangles or too many, indices out of range, vertices that are not finite.
std::optional<Error> check_numbers(const TriangleMesh& soup);

// Vertices at equal positions become one; triangles with two corners in one place are dropped and counted.
TriangleMesh weld(const TriangleMesh& soup, std::uint32_t& dropped);

// (triangles) which have the corners of one before them, whichever way round: which way is right is found out
// by what is around them.
std::vector<bool> repeated_triangles(const TriangleMesh& welded);

// How many places were mended, and where the first of them is.
struct Mended {
  std::size_t count = 0;
  Vec3 place = Vec3::Zero();  // (3) m

  void add(const Vec3& where) {
    if (count++ == 0) place = where;
  }
};

// Joins vertices at open edges that lie within `width_m` of each other, as exporters that tessellate face by
// face leave them, and drops the triangles that collapse. Answers which vertices moved.
Mended close_cracks(TriangleMesh& mesh, double width_m);

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
