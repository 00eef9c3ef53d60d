#include "haptics/bake/brick_bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSmooth =
    0.02;  // voxels of error by second differences, below which they are taken at their word
constexpr std::size_t kMeasured = 16;  // cells of a brick, those that bend most
// A kink of slope jump s between two lattice points costs at most s h/4, and shows as a second difference of
// at least s h/2 at one of them: no cell errs by more than this many times its bend.
constexpr double kErrorPerBend = 4.0;
constexpr double kMargin =
    1.5;  // for what lies between the places measured; the tests hold it against random ones

constexpr std::array<int, 3> kSteps{1, kBrickSide, kBrickSide* kBrickSide};

int index_of(int i, int j, int k) {
  return i + kBrickSide * (j + kBrickSide * k);
}

double interpolate(std::span<const float> values, int cell, const Vec3& t) {
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    int index = cell;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = ((corner >> axis) & 1) != 0;
      weight *= upper ? t[axis] : 1.0 - t[axis];
      if (upper) index += kSteps[static_cast<std::size_t>(axis)];
    }
    sum += weight * static_cast<double>(values[static_cast<std::size_t>(index)]);
  }
  return sum;
}

// Whether the band can reach a cell.
bool is_near(std::span<const float> values, int cell, double near_m) {
  for (int corner = 0; corner < 8; ++corner) {
    int index = cell;
    for (std::size_t axis = 0; axis < 3; ++axis) index += ((corner >> axis) & 1) * kSteps[axis];
    if (std::abs(static_cast<double>(values[static_cast<std::size_t>(index)])) > near_m) return false;
  }
  return true;
}

// |second difference| along each axis at every lattice point; at the brick's faces that of the next point
// inwards.
using Bends = std::array<std::array<float, kBrickValues>, 3>;

Bends second_differences(std::span<const float> values) {
  Bends bends;
  for (int k = 0; k < kBrickSide; ++k) {
    for (int j = 0; j < kBrickSide; ++j) {
      for (int i = 0; i < kBrickSide; ++i) {
        const std::array<int, 3> node{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const int inwards = std::clamp(node[axis], 1, kBrickCells - 1) - node[axis];
          const auto index = static_cast<std::size_t>(index_of(i, j, k) + inwards * kSteps[axis]);
          const auto step = static_cast<std::size_t>(kSteps[axis]);
          bends[axis][static_cast<std::size_t>(index_of(i, j, k))] =
              std::abs(values[index - step] - 2.0f * values[index] + values[index + step]);
        }
      }
    }
  }
  return bends;
}

// (sum over the axes of the largest second difference at the cell's corners) / 8, in m.
double bend(const Bends& bends, int cell) {
  float sum = 0.0f;
  for (const auto& along : bends) {
    float largest = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
      const int index = cell + (corner & 1) + ((corner >> 1) & 1) * kSteps[1] + (corner >> 2) * kSteps[2];
      largest = std::max(largest, along[static_cast<std::size_t>(index)]);
    }
    sum += largest;
  }
  return static_cast<double>(sum) / 8.0;
}

float lattice_value(UnionDistance& exact, const BrickPlace& place, const std::array<int, 3>& node) {
  return static_cast<float>(exact(place.corner + place.voxel_m * Vec3(node[0], node[1], node[2])));
}

double measure_cell(UnionDistance& exact, const Vec3& corner, double voxel_m, std::span<const float> values,
                    int cell) {
  Vec3 surface;
  const Vec3 middle = Vec3::Constant(0.5);
  double worst =
      std::abs(interpolate(values, cell, middle) - exact.closest(corner + voxel_m * middle, surface));
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Vec3 face = middle;
    face[axis] = 0.0;
    worst = std::max(worst, std::abs(interpolate(values, cell, face) - exact(corner + voxel_m * face)));
  }
  const Vec3 t = (surface - corner) / voxel_m;
  if ((t.array() >= 0.0).all() && (t.array() <= 1.0).all())
    worst = std::max(worst, std::abs(interpolate(values, cell, t) - exact(surface)));
  return worst;
}

}  // namespace

void fill_own_values(UnionDistance& exact, const BrickPlace& place, std::span<float> values) {
  for (int k = 0; k < kBrickCells; ++k) {
    for (int j = 0; j < kBrickCells; ++j)
      for (int i = 0; i < kBrickCells; ++i)
        values[static_cast<std::size_t>(index_of(i, j, k))] = lattice_value(exact, place, {i, j, k});
  }
}

void fill_shared_values(UnionDistance& exact, const BrickPlace& place, const Neighbours& neighbours,
                        std::span<float> values) {
  for (int k = 0; k < kBrickSide; ++k) {
    for (int j = 0; j < kBrickSide; ++j) {
      for (int i = 0; i < kBrickSide; ++i) {
        const int which = i / kBrickCells + 2 * (j / kBrickCells) + 4 * (k / kBrickCells);
        if (which == 0) continue;
        const float* there = neighbours[static_cast<std::size_t>(which)];
        values[static_cast<std::size_t>(index_of(i, j, k))] =
            there != nullptr ? there[index_of(i % kBrickCells, j % kBrickCells, k % kBrickCells)]
                             : lattice_value(exact, place, {i, j, k});
      }
    }
  }
}

double measure_brick(UnionDistance& exact, const BrickPlace& place, std::span<const float> values) {
  struct Cell {
    double bend;
    std::array<int, 3> node;
  };
  const Bends bends = second_differences(values);
  std::vector<Cell> bent;
  double worst = 0.0;
  for (int k = 0; k < kBrickCells; ++k) {
    for (int j = 0; j < kBrickCells; ++j) {
      for (int i = 0; i < kBrickCells; ++i) {
        if (!is_near(values, index_of(i, j, k), place.near_m)) continue;
        const Cell cell{bend(bends, index_of(i, j, k)), {i, j, k}};
        if (cell.bend > kSmooth * place.voxel_m)
          bent.push_back(cell);
        else
          worst = std::max(worst, cell.bend);
      }
    }
  }
  std::stable_sort(bent.begin(), bent.end(), [](const Cell& l, const Cell& r) { return l.bend > r.bend; });
  for (std::size_t i = 0; i < bent.size() && kErrorPerBend * bent[i].bend > worst; ++i) {
    const auto& [i0, j0, k0] = bent[i].node;
    worst =
        std::max(worst, i < kMeasured ? measure_cell(exact, place.corner + place.voxel_m * Vec3(i0, j0, k0),
                                                     place.voxel_m, values, index_of(i0, j0, k0))
                                      : bent[i].bend);
  }
  return std::min(kMargin * worst, std::numbers::sqrt3 / 2.0 * place.voxel_m);
}

}  // namespace fulcrum
