#include "haptics/bake/brick_bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSmooth = 0.02;  // voxels of error by second differences, below which they are taken at their word
constexpr std::size_t kMeasured = 24;  // cells of a brick, those that bend most
constexpr double kMargin = 1.5;   // for what lies between the places measured; the tests hold it against random ones

constexpr std::array<int, 3> kSteps{1, kBrickSide, kBrickSide * kBrickSide};

int index_of(int i, int j, int k) { return i + kBrickSide * (j + kBrickSide * k); }

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

// (sum over the axes of the largest second difference next to the cell) / 8, in m.
double bend(std::span<const float> values, const std::array<int, 3>& cell) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double largest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      std::array<int, 3> node{};
      for (std::size_t a = 0; a < 3; ++a) node[a] = cell[a] + ((corner >> a) & 1);
      node[axis] = std::clamp(node[axis], 1, kBrickCells - 1);
      const auto index = static_cast<std::size_t>(index_of(node[0], node[1], node[2]));
      const auto step = static_cast<std::size_t>(kSteps[axis]);
      const double second = static_cast<double>(values[index - step]) - 2.0 * static_cast<double>(values[index]) +
                            static_cast<double>(values[index + step]);
      largest = std::max(largest, std::abs(second));
    }
    sum += largest;
  }
  return sum / 8.0;
}

double measure_cell(UnionDistance& exact, const Vec3& corner, double voxel_m, std::span<const float> values,
                    int cell) {
  Vec3 surface;
  const Vec3 middle = Vec3::Constant(0.5);
  double worst = std::abs(interpolate(values, cell, middle) - exact.closest(corner + voxel_m * middle, surface));
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Vec3 face = middle;
    face[axis] = 0.0;
    worst = std::max(worst, std::abs(interpolate(values, cell, face) - exact(corner + voxel_m * face)));
  }
  const Vec3 t = (surface - corner) / voxel_m;
  if ((t.array() >= 0.0).all() && (t.array() <= 1.0).all()) {
    worst = std::max(worst, std::abs(interpolate(values, cell, t) - exact(surface)));
  }
  return worst;
}

}  // namespace

void fill_brick(UnionDistance& exact, const Vec3& corner, double voxel_m, std::span<float> values) {
  for (int k = 0; k < kBrickSide; ++k) {
    for (int j = 0; j < kBrickSide; ++j) {
      for (int i = 0; i < kBrickSide; ++i) {
        values[static_cast<std::size_t>(index_of(i, j, k))] =
            static_cast<float>(exact(corner + voxel_m * Vec3(i, j, k)));
      }
    }
  }
}

double measure_brick(UnionDistance& exact, const Vec3& corner, double voxel_m, std::span<const float> values) {
  struct Cell {
    double bend;
    std::array<int, 3> place;
  };
  std::vector<Cell> bent;
  double worst = 0.0;
  for (int k = 0; k < kBrickCells; ++k) {
    for (int j = 0; j < kBrickCells; ++j) {
      for (int i = 0; i < kBrickCells; ++i) {
        const Cell cell{bend(values, {i, j, k}), {i, j, k}};
        if (cell.bend > kSmooth * voxel_m) {
          bent.push_back(cell);
        } else {
          worst = std::max(worst, cell.bend);
        }
      }
    }
  }
  std::stable_sort(bent.begin(), bent.end(), [](const Cell& l, const Cell& r) { return l.bend > r.bend; });
  for (std::size_t i = 0; i < bent.size(); ++i) {
    const auto& [cell_bend, place] = bent[i];
    worst = std::max(worst, i < kMeasured ? measure_cell(exact, corner + voxel_m * Vec3(place[0], place[1], place[2]),
                                                         voxel_m, values, index_of(place[0], place[1], place[2]))
                                          : cell_bend);
  }
  return std::min(kMargin * worst, std::numbers::sqrt3 / 2.0 * voxel_m);
}

}  // namespace fulcrum
