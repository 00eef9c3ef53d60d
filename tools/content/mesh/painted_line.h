#pragma once
// Figures and letters in paint: lines in a plane, as round strokes on a face.

#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

using PaintedLine = std::vector<Eigen::Vector2d>;  // (n x 2), x to the right and y up, in any unit

PaintedLine arc(const Eigen::Vector2d& centre, const Eigen::Vector2d& radii, double from_deg, double to_deg);
PaintedLine ring(const Eigen::Vector2d& centre, const Eigen::Vector2d& radii);

// A stroke that is sunk into the face, the plane z = 0 of F, as deep as it can be and still be seen. unit: of
// the line, m; half: of the stroke's width, m. A line that ends where it begins is a ring.
Solid painted(const PaintedLine& line, double unit, double half, const Eigen::Isometry3d& X_WF);

}  // namespace fulcrum::content
