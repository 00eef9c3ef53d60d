#pragma once
// The voxel a distance field is baked with: as given, or as coarse as the wanted error and the thinnest wall
// allow.

#include "haptics/bake/field_bake.h"
#include "haptics/bake/triangle_distance.h"
#include "haptics/bake/wall_thickness.h"

namespace fulcrum {

struct Resolution {
  double voxel_m = 0.0;
  double band_m = 0.0;
  VoxelReason reason = VoxelReason::given;
  double contact_error_m = 0.0;  // measured with that voxel
};

// Measured, not modelled: at points spread over the surface, how far the interpolant between the exact
// distances of a lattice's corners is from zero; the error that 95 % of the surface keeps. On smooth surfaces
// it is of second order, h^2/8 times the curvatures; along edges up to .3 h, which no reasonable voxel brings
// down: so a chosen voxel is at most 20 errors, and then measured and made smaller until the error holds.
double contact_error(const Solid& solid, const TriangleDistance& exact, double voxel_m, unsigned threads);

// Refused, with the numbers that would serve: lengths that are not positive and finite, a band of less than
// two voxels, a wall that the given voxel does not fit into three times, a wall so thin that three voxels
// across it need more memory than may be chosen (512 MB, estimated).
Result<Resolution> choose_resolution(const Solid& solid, const TriangleDistance& exact,
                                     const ThinSpot& thinnest, const FieldDesc& desc);

}  // namespace fulcrum
