#pragma once
// Which components of a solid can hold a given point: an octree whose leaves list them. What is not listed at
// a point does not hold it; the distance to a component being 1-Lipschitz, one question at a cell's centre
// settles the cell.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

class Containment {
public:
  struct Candidate {
    std::uint32_t component;
    std::uint32_t hint;  // its triangle nearest to the cell's centre
  };
  // Signed distance in m from a point to a component; the hint is a triangle near p, and becomes the nearest.
  using Distance = std::function<double(std::uint32_t component, const Vec3& p, std::uint32_t& hint)>;

  // all: every component with any triangle of it.
  Containment(const Box3& bounds, std::span<const Candidate> all, const Distance& distance);

  std::span<const Candidate> candidates(const Vec3& p) const;

private:
  struct Cell {
    std::uint32_t first_child = 0;       // of eight; 0: a leaf
    std::uint32_t first = 0, count = 0;  // of a leaf's list in lists_
  };
  void divide(std::uint32_t cell, const Vec3& centre, double half_edge, std::span<const Candidate> parent,
              int depth, const Distance& distance);

  Vec3 centre_ = Vec3::Zero();
  double half_edge_ = 0.0;
  std::vector<Cell> cells_;
  std::vector<Candidate> lists_;
};

}  // namespace fulcrum
