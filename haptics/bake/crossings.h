#pragma once
// Where triangles of one surface pass through each other.

#include <array>
#include <optional>

#include "haptics/bake/triangle_tree.h"

namespace fulcrum {

using Corners3 = std::array<Vec3, 3>;  // (3 x 3) m

Corners3 corners_of(const TriangleMesh& mesh, std::uint32_t triangle);

enum class Meeting : unsigned char {
  apart,
  touching,  // within `depth` of each other in a point, or in an area of one plane
  abutting,  // along a line longer than `depth`, where one of them ends
  crossing,  // along a line longer than `depth`, and both reach more than `depth` beyond it on either side
};

// T. Moller, "A fast triangle-triangle intersection test" (Journal of Graphics Tools 2(2), 1997).
Meeting meeting(const Corners3& a, const Corners3& b, double depth);

// They lie within `depth` of each other's planes and share an area there.
bool overlap(const Corners3& a, const Corners3& b, double depth);

// Returns a triangle that lies inside the component's own volume, or nothing where the surface does not
// intersect itself. Where it does, triangles cross; or, along edges that agree, triangles touch that are not
// neighbours, and the winding number on their two sides tells.
std::optional<std::uint32_t> find_crossing(const Solid& solid, std::uint32_t component,
                                           const TriangleTree& tree, double depth);

}  // namespace fulcrum
