#pragma once
// One brick of a distance field: its lattice values, and how far their interpolant is from the exact distance.

#include <span>

#include "haptics/bake/union_distance.h"
#include "haptics/geometry/distance_field.h"

namespace fulcrum {

// values: (9^3) m, filled with the exact distance at corner + voxel_m (i, j, k), x fastest.
void fill_brick(UnionDistance& exact, const Vec3& corner, double voxel_m, std::span<float> values);

// The largest |interpolant - exact| in m, measured and then given a margin; at most sqrt(3)/2 voxel.
//
// Where the lattice bends little the error is h^2/8 (|f_xx| + |f_yy| + |f_zz|) by its second differences (ground
// truths, distance fields). In the cells that bend most the exact distance is asked at the centre, at three of the
// faces' centres, and at the surface point nearest to the centre: the error peaks at the surface's edges and corners.
double measure_brick(UnionDistance& exact, const Vec3& corner, double voxel_m, std::span<const float> values);

}  // namespace fulcrum
