#include "haptics/geometry/distance_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr int kHalfBrick = kBrickCells / 2;
constexpr int kStepY = kBrickSide;
constexpr int kStepZ = kBrickSide * kBrickSide;
constexpr double kNoDirection = 1e-6;  // a gradient shorter than this (it should be 1) points nowhere

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

Vec3 unit_or(const Vec3& v, const Vec3& fallback) {
  const double length = v.norm();
  return length > kNoDirection && std::isfinite(length) ? Vec3(v / length) : fallback;
}

// Value and gradient (per cell) of the trilinear interpolant between eight corners, x fastest.
struct Trilinear {
  double value;
  Vec3 slope;
};

Trilinear interpolate(const std::array<double, 8>& corner, const Vec3& t) {
  double value_x[4], slope_x[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = corner[2 * i], b = corner[2 * i + 1];
    value_x[i] = mix(a, b, t.x());
    slope_x[i] = b - a;
  }
  const double low_z = mix(value_x[0], value_x[1], t.y()), high_z = mix(value_x[2], value_x[3], t.y());
  return {mix(low_z, high_z, t.z()),
          Vec3(mix(mix(slope_x[0], slope_x[1], t.y()), mix(slope_x[2], slope_x[3], t.y()), t.z()),
               mix(value_x[1] - value_x[0], value_x[3] - value_x[2], t.z()), high_z - low_z)};
}

}  // namespace

// Where a point falls in the grid.
struct DistanceField::Cell {
  bool in_grid = false;
  Eigen::Vector3i brick = Eigen::Vector3i::Zero();
  std::size_t index = 0;            // of the brick
  bool stored = false;              // the brick has values
  std::size_t lowest = 0;           // where those of the cell begin
  Vec3 t = Vec3::Zero();            // (3) 0 to 1 within the cell
  Vec3 from_centre = Vec3::Zero();  // (3) cells, from the brick's centre
};

DistanceField::DistanceField(FieldData data) : data_(std::move(data)), cells_per_m_(1.0 / data_.voxel_m) {
  const Eigen::Vector3d cells =
      Eigen::Vector3i(data_.bricks[0], data_.bricks[1], data_.bricks[2]).cast<double>() * kBrickCells;
  grid_box_ = Box3(data_.origin, data_.origin + cells * data_.voxel_m);
}

DistanceField::Cell DistanceField::locate(const Vec3& p_W) const noexcept {
  Cell cell;
  cell.in_grid = grid_box_.contains(p_W);  // false for NaN
  if (!cell.in_grid) return cell;
  const Vec3 q = (p_W - data_.origin) * cells_per_m_;
  Eigen::Vector3i within;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const int last = data_.bricks[static_cast<std::size_t>(axis)] * kBrickCells - 1;
    const int i = std::clamp(static_cast<int>(q[axis]), 0, last);
    cell.t[axis] = q[axis] - i;
    cell.brick[axis] = i / kBrickCells;
    within[axis] = i % kBrickCells;
    cell.from_centre[axis] = q[axis] - (cell.brick[axis] * kBrickCells + kHalfBrick);
  }
  cell.index = static_cast<std::size_t>(
      (cell.brick.z() * data_.bricks[1] + cell.brick.y()) * data_.bricks[0] + cell.brick.x());
  const std::int32_t slot = data_.brick_slot[cell.index];
  cell.stored = slot != kNoBrick;
  if (cell.stored)
    cell.lowest = static_cast<std::size_t>(slot) * kBrickValues +
                  static_cast<std::size_t>(within.x() + kStepY * within.y() + kStepZ * within.z());
  return cell;
}

DistanceField::Corners DistanceField::corners(const Cell& cell) const noexcept {
  Corners result;
  const auto take = [&](const auto& values) {
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] =
          data_.quantum_m *
          static_cast<double>(values[cell.lowest + (i & 1) + (i >> 1 & 1) * kStepY + (i >> 2) * kStepZ]);
  };
  data_.format == FieldFormat::int16 ? take(data_.values_int16) : take(data_.values_float);
  return result;
}

// In a brick without values: no part of it lies within the band, and the distance changes by at most the way
// from the centre.
double DistanceField::lower_bound(const Cell& cell) const noexcept {
  const double centre = data_.centre_m[cell.index];
  const double least = std::abs(centre) - cell.from_centre.norm() * data_.voxel_m;
  return std::copysign(std::max(least, data_.band_m), centre);
}

// Of points outside the grid. The surface lies within the bounds, so it is no nearer than they are.
double DistanceField::distance_to_bounds(const Vec3& p_W) const noexcept {
  if (!p_W.allFinite()) return kFarOutside_m;
  return std::min(data_.surface_box.exteriorDistance(p_W), kFarOutside_m);
}

double DistanceField::distance(const Vec3& p_W) const noexcept {
  const Cell cell = locate(p_W);
  if (cell.stored) return interpolate(corners(cell), cell.t).value;
  if (cell.in_grid) return lower_bound(cell);
  return distance_to_bounds(p_W);
}

FieldSample DistanceField::sample(const Vec3& p_W) const noexcept {
  const Cell cell = locate(p_W);
  if (cell.stored) {
    const Trilinear found = interpolate(corners(cell), cell.t);
    FieldSample result{found.value, found.slope * cells_per_m_, std::abs(found.value) <= data_.band_m};
    if (result.gradient.norm() > kNoDirection)
      result.gradient.normalize();
    else
      result.gradient = coarse_sample(cell).gradient;  // midway between two walls
    return result;
  }
  if (cell.in_grid) return coarse_sample(cell);
  const Vec3 nearest = p_W.cwiseMax(data_.surface_box.min()).cwiseMin(data_.surface_box.max());
  return {distance_to_bounds(p_W), unit_or(p_W - nearest, Vec3::UnitY()), false};
}

double DistanceField::local_error_m(const Vec3& p_W) const noexcept {
  const Cell cell = locate(p_W);
  if (!cell.stored) return 0.0;
  const double measured = data_.slot_error_m[static_cast<std::size_t>(data_.brick_slot[cell.index])];
  if (std::abs(interpolate(corners(cell), cell.t).value) <= data_.band_m) return measured;
  // At a distance d the level sets bend by at most 1/d in two directions: h^2/8 (1/d + 1/d).
  return std::max(measured, data_.voxel_m * data_.voxel_m / (4.0 * data_.band_m) + 0.5 * quantum_m());
}

// A lower bound, and the direction in which the centres' distances grow from brick to brick.
FieldSample DistanceField::coarse_sample(const Cell& cell) const noexcept {
  Vec3 slope;
  std::size_t stride = 1;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const int last = data_.bricks[static_cast<std::size_t>(axis)] - 1;
    const std::size_t below = cell.brick[axis] > 0 ? stride : 0, above = cell.brick[axis] < last ? stride : 0;
    slope[axis] = static_cast<double>(data_.centre_m[cell.index + above]) -
                  static_cast<double>(data_.centre_m[cell.index - below]);
    stride *= static_cast<std::size_t>(last) + 1;
  }
  const double scale = 1.0 / (2.0 * kBrickCells * data_.voxel_m);
  return {lower_bound(cell), unit_or(slope * scale, Vec3::UnitY()), false};
}

std::size_t DistanceField::bytes() const {
  return data_.brick_slot.size() * sizeof(std::int32_t) + data_.centre_m.size() * sizeof(float) +
         data_.values_float.size() * sizeof(float) + data_.values_int16.size() * sizeof(std::int16_t) +
         data_.slot_error_m.size() * sizeof(float);
}

void quantise(FieldData& data) {
  // A stored brick has a point within half a brick's diagonal and the band; its values span its diagonal.
  const double largest = data.band_m + std::numbers::sqrt3 * (kBrickCells + 1) * data.voxel_m;
  constexpr double kMax = 32767;
  data.format = FieldFormat::int16;
  data.quantum_m = static_cast<double>(static_cast<float>(largest / kMax));
  data.values_int16.reserve(data.values_float.size());
  for (const float value : data.values_float)
    data.values_int16.push_back(static_cast<std::int16_t>(
        std::clamp(std::round(static_cast<double>(value) / data.quantum_m), -kMax, kMax)));
  data.values_float = {};
  for (float& error : data.slot_error_m)
    error = std::nextafter(static_cast<float>(static_cast<double>(error) + 0.5 * data.quantum_m), 1.0f);
  data.error_bound_m = *std::max_element(data.slot_error_m.begin(), data.slot_error_m.end());
}

}  // namespace fulcrum
