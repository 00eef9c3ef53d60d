#include "haptics/bake/edge_pairing.h"

#include <algorithm>
#include <numbers>
#include <span>
#include <tuple>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

// The angle of each half-edge's triangle about the edge, counter-clockwise seen from its high end.
std::vector<double> angles_about(const TriangleMesh& mesh, std::span<const HalfEdge> fan) {
  const Vec3 origin = mesh.vertices[fan.front().low];
  const Vec3 axis = (mesh.vertices[fan.front().high] - origin).normalized();
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  std::vector<double> angles;
  for (const HalfEdge& edge : fan) {
    const Triangle& corner = mesh.triangles[edge.place / 3];
    const Vec3 apex = mesh.vertices[corner[(edge.place % 3 + 2) % 3]] - origin;
    angles.push_back(math::atan2(y.dot(apex), x.dot(apex)));
  }
  return angles;
}

// A forward triangle has its solid on the side of smaller angles, a backward one on that of larger angles.
// Wedges are closed smallest first; two faces in one place are back to back, a wedge of a whole turn, not of
// none.
void pair_fan(const TriangleMesh& mesh, std::span<const HalfEdge> fan, std::vector<std::uint32_t>& across) {
  struct Wedge {
    double angle;
    std::uint32_t forward, backward;
  };
  const std::vector<double> angles = angles_about(mesh, fan);
  std::vector<Wedge> wedges;
  for (std::size_t f = 0; f < fan.size(); ++f) {
    for (std::size_t b = 0; b < fan.size(); ++b) {
      if (!fan[f].forward || fan[b].forward) continue;
      double angle = angles[f] - angles[b];
      while (angle <= 1e-9) angle += 2.0 * std::numbers::pi;
      wedges.push_back({angle, fan[f].place, fan[b].place});
    }
  }
  std::sort(wedges.begin(), wedges.end(), [](const Wedge& l, const Wedge& r) {
    return std::tie(l.angle, l.forward, l.backward) < std::tie(r.angle, r.forward, r.backward);
  });
  for (const Wedge& wedge : wedges) {
    if (across[wedge.forward] != kNoIndex || across[wedge.backward] != kNoIndex) continue;
    across[wedge.forward] = wedge.backward;
    across[wedge.backward] = wedge.forward;
  }
}

}  // namespace

std::vector<std::uint32_t> pair_edges(const TriangleMesh& welded, const EdgeFans& fans) {
  std::vector<std::uint32_t> across(fans.half_edges(), kNoIndex);
  fans.for_each([&](std::span<const HalfEdge> fan) {
    const auto forward = static_cast<std::size_t>(
        std::count_if(fan.begin(), fan.end(), [](const HalfEdge& edge) { return edge.forward; }));
    if (2 * forward == fan.size()) pair_fan(welded, fan, across);
  });
  return across;
}

}  // namespace fulcrum
