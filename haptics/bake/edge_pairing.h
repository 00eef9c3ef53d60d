#pragma once
// Which triangle lies across each edge of a welded soup, where that has an answer.

#include <cstdint>
#include <vector>

#include "haptics/bake/edge_fans.h"

namespace fulcrum {

// (3 m) for edge e of triangle t, at 3 t + e: the half-edge across, at 3 t' + e'; kNoIndex where as many
// triangles do not run along the edge as against it.
//
// An edge of 2n triangles, n each way, is taken as n edges that touch: each triangle is paired with the one
// that bounds, with it, the thinnest wedge of solid.
std::vector<std::uint32_t> pair_edges(const TriangleMesh& welded, const EdgeFans& fans);

}  // namespace fulcrum
