#pragma once
// Points hashed into cubes of one size, for questions about the neighbourhood of a place.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <unordered_map>
#include <vector>

#include "haptics/bake/sharp_features.h"

namespace fulcrum {

class PointGrid {
public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  explicit PointGrid(double cube_m) : cube_m_(cube_m) {}

  void add(const SurfacePoint& point) {
    cubes_[key(cube_of(point.position))].push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(point);
  }
  const std::vector<SurfacePoint>& points() const { return points_; }

  // The nearest point that `counts(point)`, and its distance; kNone if there is none within reach_m.
  struct Nearest {
    std::uint32_t index = kNone;
    double distance = std::numeric_limits<double>::infinity();  // m
  };
  template <class Counts>
  Nearest nearest(const Vec3& p, double reach_m, const Counts& counts) const {
    Nearest best;
    const Cube middle = cube_of(p);
    // Points in cubes of ring r are at least (r - 1) cubes away.
    for (int ring = 0; (ring - 1) * cube_m_ < reach_m && (ring - 1) * cube_m_ < best.distance; ++ring)
      look_at_ring(p, middle, ring, counts, best);
    return best.distance <= reach_m ? best : Nearest{};
  }

  // visit(point) for every point that is reach_m away at most.
  template <class Visit>
  void visit_within(const Vec3& p, double reach_m, const Visit& visit) const {
    const Cube low = cube_of(p.array() - reach_m), high = cube_of(p.array() + reach_m);
    for (int k = low.z(); k <= high.z(); ++k) {
      for (int j = low.y(); j <= high.y(); ++j) {
        for (int i = low.x(); i <= high.x(); ++i) {
          const auto found = cubes_.find(key(Cube(i, j, k)));
          if (found == cubes_.end()) continue;
          for (const std::uint32_t index : found->second)
            if ((points_[index].position - p).norm() <= reach_m) visit(points_[index]);
        }
      }
    }
  }

private:
  using Cube = Eigen::Vector3i;

  Cube cube_of(const Vec3& p) const { return (p / cube_m_).array().floor().cast<int>(); }
  static std::uint64_t key(const Cube& cube) {  // 21 bits an axis
    const auto bits = [](int i) { return static_cast<std::uint64_t>(i) & 0x1fffffu; };
    return bits(cube.x()) << 42 | bits(cube.y()) << 21 | bits(cube.z());
  }

  template <class Counts>
  void look_at_ring(const Vec3& p, const Cube& middle, int ring, const Counts& counts, Nearest& best) const {
    for (int k = -ring; k <= ring; ++k) {
      for (int j = -ring; j <= ring; ++j) {
        const bool whole_row = std::abs(k) == ring || std::abs(j) == ring;
        for (int i = -ring; i <= ring; i += whole_row ? 1 : std::max(1, 2 * ring)) {
          const auto found = cubes_.find(key(middle + Cube(i, j, k)));
          if (found == cubes_.end()) continue;
          for (const std::uint32_t index : found->second) {
            const double distance = (points_[index].position - p).norm();
            if (distance < best.distance && counts(points_[index])) best = {index, distance};
          }
        }
      }
    }
  }

  double cube_m_;
  std::vector<SurfacePoint> points_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

}  // namespace fulcrum
