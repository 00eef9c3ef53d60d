#pragma once
// A distance field as the SIMD look-up reads it: bare arrays, single precision, cells in place of metres.

#include <array>
#include <cstdint>

#include "haptics/geometry/distance_field.h"

namespace fulcrum {

struct FieldView {
  const std::int32_t* brick_slot;  // (bricks)
  const float* centre_m;           // (bricks)
  const void* values;              // (slots x 9^3) int16_t or float, as the format says
  FieldFormat format;
  float quantum_m;
  float voxel_m;
  float band_m;
  std::array<std::int32_t, 3> bricks;
  std::array<float, 3> cells;     // (3) of the grid
  std::array<float, 3> box_low;   // (3) cells, the solid's bounds
  std::array<float, 3> box_high;  // (3) cells
};

inline FieldView view_of(const DistanceField& field) {
  const FieldData& data = field.data();
  FieldView view{};
  view.brick_slot = data.brick_slot.data();
  view.centre_m = data.centre_m.data();
  view.format = data.format;
  view.values = data.format == FieldFormat::int16 ? static_cast<const void*>(data.values_int16.data())
                                                  : static_cast<const void*>(data.values_float.data());
  view.quantum_m = static_cast<float>(data.quantum_m);
  view.voxel_m = static_cast<float>(data.voxel_m);
  view.band_m = static_cast<float>(data.band_m);
  view.bricks = data.bricks;
  const Vec3 low = (data.surface_box.min() - data.origin) / data.voxel_m;
  const Vec3 high = (data.surface_box.max() - data.origin) / data.voxel_m;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    view.cells[i] = static_cast<float>(data.bricks[i] * kBrickCells);
    view.box_low[i] = static_cast<float>(low[axis]);
    view.box_high[i] = static_cast<float>(high[axis]);
  }
  return view;
}

}  // namespace fulcrum
