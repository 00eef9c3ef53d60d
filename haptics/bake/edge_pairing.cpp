#include "haptics/bake/edge_pairing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

namespace fulcrum {
namespace {

struct HalfEdge {
  std::uint32_t low, high;  // vertices, low < high
  std::uint32_t place;      // 3 t + e
  bool forward;             // runs from low to high
};

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      const std::uint32_t from = mesh.triangles[t][e], to = mesh.triangles[t][(e + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), 3 * t + e, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& l, const HalfEdge& r) {
    return std::tie(l.low, l.high, l.place) < std::tie(r.low, r.high, r.place);
  });
  return edges;
}

// The angle of each half-edge's triangle about the edge, counter-clockwise seen from its high end.
std::vector<double> angles_about(const TriangleMesh& mesh, std::span<const HalfEdge> fan) {
  const Vec3 origin = mesh.vertices[fan.front().low];
  const Vec3 axis = (mesh.vertices[fan.front().high] - origin).normalized();
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  std::vector<double> angles;
  for (const HalfEdge& edge : fan) {
    const Triangle& corner = mesh.triangles[edge.place / 3];
    const Vec3 apex = mesh.vertices[corner[(edge.place % 3 + 2) % 3]] - origin;
    angles.push_back(std::atan2(y.dot(apex), x.dot(apex)));
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
    if (across[wedge.forward] != EdgePairing::kNone || across[wedge.backward] != EdgePairing::kNone) continue;
    across[wedge.forward] = wedge.backward;
    across[wedge.backward] = wedge.forward;
  }
}

}  // namespace

EdgePairing pair_edges(const TriangleMesh& welded) {
  const std::vector<HalfEdge> edges = sorted_half_edges(welded);
  EdgePairing result;
  result.across.assign(edges.size(), EdgePairing::kNone);
  const auto note = [&](EdgePairing::Fault& fault, const HalfEdge& edge) {
    if (fault.edges++ > 0) return;
    fault.from = welded.vertices[edge.low];
    fault.to = welded.vertices[edge.high];
  };

  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::find_if(
        begin, edges.end(), [&](const HalfEdge& e) { return e.low != begin->low || e.high != begin->high; });
    const std::span<const HalfEdge> fan(begin, end);
    const auto forward = static_cast<std::size_t>(
        std::count_if(fan.begin(), fan.end(), [](const HalfEdge& edge) { return edge.forward; }));
    if (fan.size() == 1) {
      note(result.open, fan.front());
    } else if (2 * forward == fan.size()) {
      pair_fan(welded, fan, result.across);
    } else {
      note(fan.size() == 2 ? result.twisted : result.tangled, fan.front());
    }
    begin = end;
  }
  return result;
}

}  // namespace fulcrum
