#include "haptics/bake/covering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSlack = 1.02;

using Piece = std::array<Vec3, 3>;

}  // namespace

// Branch and bound: within a piece of a triangle nothing is farther from the points than its centroid is,
// plus the centroid's distance to the farthest corner. Pieces that could exceed the bound so far are cut into
// two.
double covering_radius(const Solid& solid, const PointGrid& grid, double seen) {
  double farthest = seen, proven = seen;
  std::vector<Piece> pieces;
  for (const Triangle& triangle : solid.mesh.triangles) {
    pieces.push_back({solid.mesh.vertices[triangle[0]], solid.mesh.vertices[triangle[1]],
                      solid.mesh.vertices[triangle[2]]});
    while (!pieces.empty()) {
      Piece piece = pieces.back();
      pieces.pop_back();
      const Vec3 centroid = (piece[0] + piece[1] + piece[2]) / 3.0;
      const double distance = grid.nearest(centroid, std::numeric_limits<double>::infinity(),
                                           [](const SurfacePoint&) { return true; })
                                  .distance;
      const double radius = std::max(
          {(piece[0] - centroid).norm(), (piece[1] - centroid).norm(), (piece[2] - centroid).norm()});
      farthest = std::max(farthest, distance);
      if (distance + radius <= kSlack * farthest) {
        proven = std::max(proven, distance + radius);
        continue;
      }
      const auto length = [&piece](std::size_t e) { return (piece[(e + 1) % 3] - piece[e]).squaredNorm(); };
      const std::size_t longest =
          length(0) >= length(1) ? (length(0) >= length(2) ? 0 : 2) : (length(1) >= length(2) ? 1 : 2);
      const Vec3 middle = 0.5 * (piece[longest] + piece[(longest + 1) % 3]);
      Piece other = piece;
      piece[longest] = middle;
      other[(longest + 1) % 3] = middle;
      pieces.push_back(piece);
      pieces.push_back(other);
    }
  }
  return proven;
}

}  // namespace fulcrum
