#pragma once
// One brick of a distance field: its lattice values, and how far their interpolant is from the exact
// distance.

#include <array>
#include <span>

#include "haptics/bake/union_distance.h"
#include "haptics/geometry/distance_field.h"

namespace fulcrum {

struct BrickPlace {
  Vec3 corner;     // (3) m, the lowest
  double voxel_m;  // cell edge
  double near_m;   // |distance| up to which the values of cells that the band reaches may go
};

// values: (9^3) m at corner + voxel_m (i, j, k), x fastest. First the brick's own, i, j, k < 8.
void fill_own_values(UnionDistance& exact, const BrickPlace& place, std::span<float> values);

// Then the rest, copied from the bricks next to it where they have values. Bit b of a neighbour's number says
// that it lies one brick further along axis b; null: it has no values.
using Neighbours = std::array<const float*, 8>;
void fill_shared_values(UnionDistance& exact, const BrickPlace& place, const Neighbours& neighbours,
                        std::span<float> values);

// The largest |interpolant - exact| in m in the cells that the band reaches, measured and then given a
// margin; at most sqrt(3)/2 voxel.
//
// Where the lattice bends little the error is h^2/8 (|f_xx| + |f_yy| + |f_zz|) by its second differences
// (ground truths, distance fields). In the cells that bend most the exact distance is asked at the centre, at
// three of the faces' centres, and at the surface point nearest to the centre: the error peaks at the
// surface's edges and corners.
double measure_brick(UnionDistance& exact, const BrickPlace& place, std::span<const float> values);

}  // namespace fulcrum
