#pragma once
// Solid -> distance field.

#include <functional>

#include "haptics/bake/solid.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/math/result.h"

namespace fulcrum {

struct FieldDesc {
  double voxel_m = 1e-3;  // cell edge
  double band_m = 2e-3;   // how far from the surface the field is stored in full; at least two voxels
  FieldFormat format = FieldFormat::int16;
  unsigned threads = 0;  // 0: as many as the machine has. The result is the same, bit for bit, for any number
};

using Progress = std::function<void(double fraction)>;  // 0 to 1, called from the calling thread only

// Refused, with the numbers that would serve: voxel or band that is not positive and finite, a wall thinner
// than two voxels (the field would have no inside there, ground truths: below about three it is already
// soft), a grid of more than 2 GB.
Result<DistanceField> bake_field(const Solid& solid, const FieldDesc& desc, const Progress& progress = {});

}  // namespace fulcrum
