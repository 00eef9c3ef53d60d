#pragma once
// Points where a surface stands out from between the points it has: rounded edges and small radii.

#include "haptics/bake/point_grid.h"
#include "haptics/bake/solid.h"
#include "haptics/bake/surface_samples.h"

namespace fulcrum {

// Adds points until no sample, edge or vertex of the solid, pressed along its normal against a flat wall,
// goes deeper than `deviation` before a point within `reach` of it touches: on a surface of curvature k,
// points about sqrt(8 deviation / k) apart. Edges are looked at in steps of a quarter of the reach. False,
// and the grid as far as it got, if there would be more than `most` points.
bool refine_by_curvature(const Solid& solid, const SurfaceSamples& samples, double deviation, double reach,
                         std::size_t most, PointGrid& grid);

}  // namespace fulcrum
