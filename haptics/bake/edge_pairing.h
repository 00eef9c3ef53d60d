#pragma once
// Which triangle lies across each edge of a welded soup, where that has an answer.

#include <cstdint>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

struct EdgePairing {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  // (3 m) for edge e of triangle t, at 3 t + e: the half-edge across, at 3 t' + e'; kNone where there is
  // none.
  std::vector<std::uint32_t> across;

  struct Fault {
    std::size_t edges = 0;     // how many
    Vec3 from = Vec3::Zero();  // (3) m, one of them
    Vec3 to = Vec3::Zero();    // (3) m
  };
  Fault open;     // edges of one triangle
  Fault twisted;  // edges whose two triangles are wound against each other
  Fault tangled;  // edges of three or more triangles that cannot be paired

  bool complete() const { return open.edges + twisted.edges + tangled.edges == 0; }
};

// An edge of 2n triangles, n each way, is taken as n edges that touch: each triangle is paired with the one
// that bounds, with it, the thinnest wedge of solid.
EdgePairing pair_edges(const TriangleMesh& welded);

}  // namespace fulcrum
