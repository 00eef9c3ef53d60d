#include "haptics/bake/edge_fans.h"

#include <algorithm>
#include <tuple>

namespace fulcrum {

EdgeFans::EdgeFans(std::span<const Triangle> triangles) {
  edges_.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      const std::uint32_t from = triangles[t][e], to = triangles[t][(e + 1) % 3];
      edges_.push_back({std::min(from, to), std::max(from, to), 3 * t + e, from < to});
    }
  }
  std::sort(edges_.begin(), edges_.end(), [](const HalfEdge& l, const HalfEdge& r) {
    return std::tie(l.low, l.high, l.place) < std::tie(r.low, r.high, r.place);
  });
}

}  // namespace fulcrum
