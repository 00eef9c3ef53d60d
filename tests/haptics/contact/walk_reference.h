#pragma once
// What walk_shell() has to give, point by point and without SIMD: the same single-precision sums, written
// out.

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "haptics/contact/shell_walk.h"

namespace fulcrum::test {

struct Looked {
  float distance = 0;
  bool touching = false, guessed = false;
  std::array<float, 3> n{};

  bool operator==(const Looked& other) const {
    return std::bit_cast<std::uint32_t>(distance) == std::bit_cast<std::uint32_t>(other.distance) &&
           touching == other.touching && guessed == other.guessed && n == other.n;
  }
};

inline float mix(float a, float b, float t) {
  return a + (b - a) * t;
}

inline float length(float x, float y, float z) {
  return std::sqrt(x * x + y * y + z * z);
}

inline float bounds_distance(const FieldView& field, const std::array<float, 3>& q) {
  std::array<float, 3> beyond{};
  for (std::size_t i = 0; i < 3; ++i)
    beyond[i] = q[i] - std::min(std::max(q[i], field.box_low[i]), field.box_high[i]);
  const float distance = length(beyond[0], beyond[1], beyond[2]) * field.voxel_m;
  const float number = q[0] + q[1] + q[2];
  return distance < static_cast<float>(kFarOutside_m) && number == number ? distance
                                                                          : static_cast<float>(kFarOutside_m);
}

inline float stored_value(const FieldView& field, std::size_t index) {
  return field.format == FieldFormat::int16
             ? static_cast<float>(static_cast<const std::int16_t*>(field.values)[index])
             : static_cast<const float*>(field.values)[index];
}

inline Looked look_up(const ShellWalk& walk, std::size_t patch, std::size_t lane) {
  const FieldView& field = walk.field;
  const SphereTree::Points& points = walk.tree->patches[patch];
  const std::array<float, 3>& middle = walk.tree->middles[patch];
  std::array<std::int32_t, 3> from{};
  std::array<float, 3> local{}, q{}, t{};
  bool in_grid = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = walk.turn[3 * i], b = walk.turn[3 * i + 1], c = walk.turn[3 * i + 2];
    const double place = a * static_cast<double>(middle[0]) + b * static_cast<double>(middle[1]) +
                         c * static_cast<double>(middle[2]) + walk.shift[i];
    if (std::abs(place) < 1e6) from[i] = static_cast<std::int32_t>(std::floor(place));
    local[i] = static_cast<float>(a) * points.x[lane] + static_cast<float>(b) * points.y[lane] +
               static_cast<float>(c) * points.z[lane] + static_cast<float>(place - from[i]);
    q[i] = local[i] + static_cast<float>(from[i]);
    in_grid = in_grid && q[i] >= 0.0f && q[i] <= field.cells[i];
  }
  Looked result;
  if (!in_grid) {
    result.distance = bounds_distance(field, q);
    result.touching = result.distance < walk.margin;
    result.guessed = result.touching;
    return result;
  }
  std::array<std::int32_t, 3> brick{}, within{};
  std::array<float, 3> from_middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t cell = std::clamp(static_cast<std::int32_t>(std::floor(local[i])) + from[i], 0,
                                         field.bricks[i] * kBrickCells - 1);
    brick[i] = cell / kBrickCells;
    within[i] = cell % kBrickCells;
    t[i] = local[i] - static_cast<float>(cell - from[i]);
    from_middle[i] = q[i] - static_cast<float>(brick[i] * kBrickCells + kBrickCells / 2);
  }
  const auto index =
      static_cast<std::size_t>((brick[2] * field.bricks[1] + brick[1]) * field.bricks[0] + brick[0]);
  const std::int32_t slot = field.brick_slot[index];
  if (slot == kNoBrick) {
    const float centre = field.centre_m[index];
    const float way = length(from_middle[0], from_middle[1], from_middle[2]) * field.voxel_m;
    result.distance = std::copysign(std::max(std::abs(centre) - way, field.band_m), centre);
    result.touching = result.distance < walk.margin;
    result.guessed = result.touching;
    return result;
  }
  const auto lowest = static_cast<std::size_t>(slot) * kBrickValues +
                      static_cast<std::size_t>(within[0] + kBrickSide * (within[1] + kBrickSide * within[2]));
  float value[4], slope[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t at = lowest + (i & 1) * kBrickSide + (i >> 1) * kBrickSide * kBrickSide;
    const float low = stored_value(field, at), high = stored_value(field, at + 1);
    value[i] = mix(low, high, t[0]);
    slope[i] = high - low;
  }
  result.distance = mix(mix(value[0], value[1], t[1]), mix(value[2], value[3], t[1]), t[2]) * field.quantum_m;
  result.touching = result.distance < walk.margin;
  if (!result.touching) return result;
  const float gx = mix(mix(slope[0], slope[1], t[1]), mix(slope[2], slope[3], t[1]), t[2]);
  const float gy = mix(value[1] - value[0], value[3] - value[2], t[2]);
  const float gz = mix(value[2], value[3], t[1]) - mix(value[0], value[1], t[1]);
  const float size = length(gx, gy, gz);
  result.guessed = !(size > 1e-3f * field.voxel_m / field.quantum_m);
  if (!result.guessed) result.n = {gx / size, gy / size, gz / size};
  return result;
}

}  // namespace fulcrum::test
