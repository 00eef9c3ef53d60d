#pragma once
// What walk_shell() and look_up_normals() have to give, point by point and without SIMD: the same
// single-precision sums, written out.

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "haptics/contact/shell_walk.h"

namespace fulcrum::test {

struct Looked {
  float distance = 0;
  bool touching = false;

  bool operator==(const Looked& other) const {
    return std::bit_cast<std::uint32_t>(distance) == std::bit_cast<std::uint32_t>(other.distance) &&
           touching == other.touching;
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

// Cells from a lattice point.
struct Spot {
  std::array<std::int32_t, 3> from{};
  std::array<float, 3> local{};
};

struct Read {
  float distance = 0;
  bool stored = false;
};

inline Read read_at(const FieldView& field, const Spot& spot) {
  std::array<float, 3> q{}, t{};
  bool in_grid = true;
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = spot.local[i] + static_cast<float>(spot.from[i]);
    in_grid = in_grid && q[i] >= 0.0f && q[i] <= field.cells[i];
  }
  if (!in_grid) return {bounds_distance(field, q), false};
  std::array<std::int32_t, 3> brick{}, within{};
  std::array<float, 3> from_middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t cell = std::clamp(static_cast<std::int32_t>(std::floor(spot.local[i])) + spot.from[i],
                                         0, field.bricks[i] * kBrickCells - 1);
    brick[i] = cell / kBrickCells;
    within[i] = cell % kBrickCells;
    t[i] = spot.local[i] - static_cast<float>(cell - spot.from[i]);
    from_middle[i] = q[i] - static_cast<float>(brick[i] * kBrickCells + kBrickCells / 2);
  }
  const auto index =
      static_cast<std::size_t>((brick[2] * field.bricks[1] + brick[1]) * field.bricks[0] + brick[0]);
  const std::int32_t slot = field.brick_slot[index];
  if (slot == kNoBrick) {
    const float centre = field.centre_m[index];
    const float way = length(from_middle[0], from_middle[1], from_middle[2]) * field.voxel_m;
    return {std::copysign(std::max(std::abs(centre) - way, field.band_m), centre), false};
  }
  const auto lowest = static_cast<std::size_t>(slot) * kBrickValues +
                      static_cast<std::size_t>(within[0] + kBrickSide * (within[1] + kBrickSide * within[2]));
  float value[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t at = lowest + (i & 1) * kBrickSide + (i >> 1) * kBrickSide * kBrickSide;
    value[i] = mix(stored_value(field, at), stored_value(field, at + 1), t[0]);
  }
  return {mix(mix(value[0], value[1], t[1]), mix(value[2], value[3], t[1]), t[2]) * field.quantum_m, true};
}

inline Looked look_up(const ShellWalk& walk, std::size_t patch, std::size_t lane) {
  const FieldView& field = walk.field;
  const SphereTree::Points& points = walk.tree->patches[patch];
  const std::array<float, 3>& middle = walk.tree->middles[patch];
  Spot spot;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = walk.turn[3 * i], b = walk.turn[3 * i + 1], c = walk.turn[3 * i + 2];
    const double place = a * static_cast<double>(middle[0]) + b * static_cast<double>(middle[1]) +
                         c * static_cast<double>(middle[2]) + walk.shift[i];
    if (std::abs(place) < 1e6) spot.from[i] = static_cast<std::int32_t>(std::floor(place));
    spot.local[i] = static_cast<float>(a) * points.x[lane] + static_cast<float>(b) * points.y[lane] +
                    static_cast<float>(c) * points.z[lane] + static_cast<float>(place - spot.from[i]);
  }
  Looked result;
  result.distance = read_at(field, spot).distance;
  result.touching = result.distance < walk.margin;
  return result;
}

struct Normal {
  bool known = false;
  std::array<float, 3> n{};
};

inline Normal normal_across_cells(const FieldView& field, const std::array<float, 3>& cells) {
  bool known = true;
  std::array<float, 3> g{};
  for (std::size_t i = 0; i < 3; ++i) {
    Spot high{{}, cells}, low{{}, cells};
    high.local[i] += 0.5f;
    low.local[i] -= 0.5f;
    const Read at_high = read_at(field, high), at_low = read_at(field, low);
    known = known && at_high.stored && at_low.stored;
    g[i] = at_high.distance - at_low.distance;
  }
  const float size = length(g[0], g[1], g[2]);
  if (!known || !(size > 1e-3f * field.voxel_m)) return {};
  return {true, {g[0] / size, g[1] / size, g[2] / size}};
}

}  // namespace fulcrum::test
