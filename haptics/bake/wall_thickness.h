#pragma once
// How thin a solid gets: what a grid has to resolve.

#include "haptics/bake/solid.h"
#include "haptics/bake/triangle_distance.h"

namespace fulcrum {

struct ThinSpot {
  double thickness_m = 0.0;
  Vec3 place = Vec3::Zero();  // (3) m, on one of its two faces
};

// An estimate: from four points of every triangle straight inwards to the facing wall of the same component.
// Walls that lean by more than 26 degrees against each other meet in an edge; that is a corner, not a thin
// wall.
ThinSpot thinnest_wall(const Solid& solid, const TriangleDistance& exact, unsigned threads);

}  // namespace fulcrum
