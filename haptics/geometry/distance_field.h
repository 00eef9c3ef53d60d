#pragma once
// The signed distance to a solid, sampled on a sparse grid: positive outside, negative inside, metres.
//
// The grid is cut into bricks of 8^3 cells. A brick that comes within the band of the surface stores its 9^3
// lattice values (the ninth layer repeats the neighbour's first, so that a look-up touches one brick); any
// other brick stores the distance at its centre, from which the way to a point is taken off. What a look-up
// promises:
//   |value| <= band_m()   |value - exact| <= sqrt(3)/2 voxel + quantum_m()/2, proven: the exact distance is
//                         1-Lipschitz and the lattice values are exact. Mostly far less: local_error_m(p) <=
//                         error_bound_m() is measured at bake (one place in a thousand of the piping scene
//                         exceeds its local one, by up to a quarter voxel)
//   elsewhere             the sign is right and |value| <= |exact| + local_error_m(p): a lower bound, not
//                         continuous from brick to brick
// "Exact" is the minimum over the solid's components: the distance to the union outside; inside, the depth in
// the component in which the point lies deepest, which is at most the depth in the union.
//
// The band is what contact needs: the depth to which a tool may sink, since a normal beyond it is a guess,
// and one voxel on the outside, so that the surface never leaves the stored bricks. Continuous motion and the
// culling of far points only need lower bounds, which the centres give. Two voxels serve; memory grows with
// the band.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/geometry/huge_vector.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/linear.h"
#include "haptics/math/names_of.h"

namespace fulcrum {

struct FieldSample {
  double distance = 0.0;          // m
  Vec3 gradient = Vec3::UnitY();  // (3) unit: the direction in which distance grows
  bool in_band = false;  // |distance| <= band; else distance is a lower bound, gradient a coarse guess
};

inline constexpr int kBrickCells = 8;               // cells along a brick's edge
inline constexpr int kBrickSide = kBrickCells + 1;  // lattice values along a brick's edge
inline constexpr int kBrickValues = kBrickSide * kBrickSide * kBrickSide;
inline constexpr std::int32_t kNoBrick = -1;
inline constexpr double kFarOutside_m =
    1e6;  // the answer for points that are not numbers, and the largest one

// How lattice values are stored.
enum class FieldFormat {
  int16,    // whole multiples of quantum_m: half the memory, and half the way for a look-up
  float32,  // as they are
};
template <>
inline constexpr std::array<std::string_view, 2> names_of<FieldFormat>{"int16", "float32"};

// What decided the voxel.
enum class VoxelReason : unsigned char {
  given,
  error,          // the coarsest that keeps the wanted contact error
  thinnest_wall,  // a third of it
  band,           // half of the given one
  memory,         // the finest that fits; the wanted contact error is not kept
};

// The stored numbers. Bricks run x fastest, then y, then z; so do the values inside a brick.
struct FieldData {
  Vec3 origin = Vec3::Zero();            // (3) m, the lowest corner of brick (0,0,0)
  double voxel_m = 0.0;                  // cell edge
  double band_m = 0.0;                   // the surface's neighbourhood that is stored in full
  std::array<std::int32_t, 3> bricks{};  // (3) bricks along x, y, z
  std::vector<std::int32_t> brick_slot;  // (bricks) slot of its values, kNoBrick: not in band
  std::vector<float> centre_m;           // (bricks) exact at the brick's centre, rounded towards zero
  // (slots x 9^3) exact at the lattice points, in one of the two, as the format says
  FieldFormat format = FieldFormat::float32;
  double quantum_m = 1.0;                 // what a stored 1 stands for
  HugeVector<float> values_float;         // m
  HugeVector<std::int16_t> values_int16;  // quanta
  std::vector<float> slot_error_m;  // (slots) largest |value - exact| measured in the band in that brick
  Box3 surface_box;                 // m, bounds of the solid
  double error_bound_m = 0.0;       // largest of slot_error_m
  double thinnest_feature_m = 0.0;  // thinnest wall met at bake
  double contact_error_m = 0.0;     // what 95 % of the surface keeps
  VoxelReason voxel_reason = VoxelReason::given;
};

// Stores float values as int16, and adds half a quantum to the errors.
void quantise(FieldData& data);

class DistanceField {
public:
  explicit DistanceField(FieldData data);  // data as bake_field() or the bake cache gives it

  // Real-time: no allocation, no throw. NaN and infinities are kFarOutside_m away.
  FieldSample sample(const Vec3& p_W) const noexcept;
  double distance(const Vec3& p_W) const noexcept;
  // What to subtract from |distance(p)| before relying on it. In band, the error measured in p's own brick;
  // beyond, what interpolation adds to a distance of band_m or more, h^2/(4 band_m), and half a quantum; in
  // bricks without values, nothing.
  double local_error_m(const Vec3& p_W) const noexcept;

  double voxel_m() const { return data_.voxel_m; }
  double band_m() const { return data_.band_m; }
  FieldFormat format() const { return data_.format; }
  double quantum_m() const { return data_.format == FieldFormat::int16 ? data_.quantum_m : 0.0; }
  double error_bound_m() const { return data_.error_bound_m; }
  double thinnest_feature_m() const { return data_.thinnest_feature_m; }
  double contact_error_m() const { return data_.contact_error_m; }
  VoxelReason voxel_reason() const { return data_.voxel_reason; }
  const Box3& bounds() const { return data_.surface_box; }  // m, of the solid
  const Box3& grid_box() const { return grid_box_; }        // m, of the grid: bounds and the band around it
  std::size_t bytes() const;                                // of the stored arrays
  const FieldData& data() const { return data_; }

private:
  struct Cell;
  using Corners = std::array<double, 8>;  // m, x fastest
  Cell locate(const Vec3& p_W) const noexcept;
  Corners corners(const Cell& cell) const noexcept;
  double lower_bound(const Cell& cell) const noexcept;
  double distance_to_bounds(const Vec3& p_W) const noexcept;
  FieldSample coarse_sample(const Cell& cell) const noexcept;

  FieldData data_;
  double cells_per_m_ = 0.0;
  Box3 grid_box_;
};

}  // namespace fulcrum
