#pragma once
// How far a surface gets from a set of points: measured, and proven to within two per cent.

#include "haptics/bake/point_grid.h"
#include "haptics/bake/solid.h"

namespace fulcrum {

// A bound in m that no point of the surface exceeds. `seen`: a distance known to occur, which the bound is at
// least.
double covering_radius(const Solid& solid, const PointGrid& grid, double seen);

}  // namespace fulcrum
