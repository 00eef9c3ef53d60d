#pragma once
// Unit normals of a distance field at several places at once, by SIMD. As of the walk over the shell, every
// target gives the same bits.

#include <array>
#include <cstdint>

#include "haptics/geometry/field_view.h"
#include "haptics/geometry/sphere_tree.h"

namespace fulcrum {

enum class Normals {
  // The interpolant's own gradient: of first order, and that of the depths, so that steps which are found
  // from it
  // end where they should.
  of_cell,
  // Differences over a cell's width: the interpolant errs by the same at two places a cell apart, so that
  // they are
  // of second order, and six times the work.
  across_cells,
};

struct alignas(64) NormalBatch {
  std::array<float, kBlock> x, y, z;     // cells
  std::array<float, kBlock> nx, ny, nz;  // unit, where known
  std::uint32_t
      known;  // bit per place; else not all around it is stored, or it is flat: midway between walls
};

void look_up_normals(const FieldView& field, Normals kind, NormalBatch& batch) noexcept;

}  // namespace fulcrum
