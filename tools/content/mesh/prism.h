#pragma once
// Machined blocks: a drawing in the plane, given a thickness along z, with every edge bevelled.

#include <span>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

using Outline = std::vector<Eigen::Vector2d>;  // (n x 2) m, counter-clockwise

// Moved inwards by a distance (m), every side parallel to itself.
Outline inset(const Outline& outline, double by);

// From -half to +half along z. The outline is convex. Sides are divided along z into pieces no longer than
// `step`, so that a coat can follow the tool marks.
Solid bevelled_prism(const Outline& outline, double half, double bevel, double step = 1.0);

// The same with a window in it, its bars as wide as `bar`.
Solid bevelled_frame(const Outline& outline, double half, double bar, double bevel);

}  // namespace fulcrum::content
