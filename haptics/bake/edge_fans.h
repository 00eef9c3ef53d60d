#pragma once
// The edges of a welded soup, each with all the triangles that share it.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

inline constexpr std::uint32_t kNoIndex = 0xffffffffu;  // no triangle, vertex or half-edge

struct HalfEdge {
  std::uint32_t low, high;  // vertices, low < high
  std::uint32_t place;      // 3 t + e: edge e of triangle t, from its corner e to corner e+1
  bool forward;             // runs from low to high
};

class EdgeFans {
public:
  explicit EdgeFans(std::span<const Triangle> triangles);

  std::size_t half_edges() const { return edges_.size(); }

  // visit(std::span<const HalfEdge>) for every edge, by rising vertices; a fan's triangles rise too.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
      while (end < edges_.size() && edges_[end].low == edges_[begin].low &&
             edges_[end].high == edges_[begin].high)
        ++end;
      visit(std::span(edges_).subspan(begin, end - begin));
    }
  }

private:
  std::vector<HalfEdge> edges_;
};

}  // namespace fulcrum
