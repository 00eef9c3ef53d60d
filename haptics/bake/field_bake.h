#pragma once
// Solid -> distance field.

#include <functional>
#include <optional>

#include "haptics/bake/solid.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/math/result.h"

namespace fulcrum {

struct FieldDesc {
  std::optional<double> voxel_m = std::nullopt;  // cell edge; without it chosen, see resolution.h
  // How far from the surface the field is stored in full; at least, and without it, two voxels.
  std::optional<double> band_m = std::nullopt;
  FieldFormat format = FieldFormat::int16;
  unsigned threads = 0;  // 0: as many as the machine has. The result is the same, bit for bit, for any number
  double error_m = 5e-5;  // wanted of contacts on 95 % of the surface, where no voxel is given
};

using Progress = std::function<void(double fraction)>;  // 0 to 1, called from the calling thread only

// Refused, with the numbers that would serve: what choose_resolution() refuses, above all a wall thinner than
// three voxels (below two the field would have no inside there), and a grid of more than 2 GB.
Result<DistanceField> bake_field(const Solid& solid, const FieldDesc& desc, const Progress& progress = {});

}  // namespace fulcrum
