#pragma once
// Fields without a mesh: a function at every lattice point.

#include <functional>
#include <utility>

#include "haptics/geometry/distance_field.h"

namespace fulcrum {

using FieldFunction = std::function<double(const Vec3&)>;

// A field of n^3 bricks about the origin, every brick stored, filled with a function.
inline DistanceField filled_field(int n, double voxel, const FieldFunction& function) {
  FieldData data;
  data.voxel_m = voxel;
  data.band_m = 1e9;
  data.bricks = {n, n, n};
  data.origin = Vec3::Constant(-0.5 * n * kBrickCells * voxel);
  data.surface_box = Box3(data.origin, -data.origin);
  for (int b = 0; b < n * n * n; ++b) {
    data.brick_slot.push_back(b);
    data.centre_m.push_back(0.0f);
    data.slot_error_m.push_back(0.0f);
    const Vec3 corner = data.origin + kBrickCells * voxel * Vec3(b % n, b / n % n, b / n / n);
    for (int k = 0; k < kBrickSide; ++k) {
      for (int j = 0; j < kBrickSide; ++j)
        for (int i = 0; i < kBrickSide; ++i)
          data.values_float.push_back(static_cast<float>(function(corner + voxel * Vec3(i, j, k))));
    }
  }
  return DistanceField(std::move(data));
}

}  // namespace fulcrum
