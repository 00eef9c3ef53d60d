#pragma once
// The workload cut into convex pieces, for libraries that collide convex hulls: where its shapes are convex
// is known from how they are drawn.

#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "tests/bench/swept_pipes.h"

namespace fulcrum::bench {

using HullPoints = std::vector<Vec3>;  // (n x 3) m, of which the hull is meant

// Each ring in 12 sectors, from one point of its hole to the next, which are convex but for the edge of their
// lead-in cone; necks, crank and shank in 12 slabs, which fill the shallow panels. In the tool's frame.
std::vector<HullPoints> spanner_pieces(const TriangleMesh& spanner_T);

// A run is a cylinder; a bend is cut every 22.5 degrees, and a piece's hull fills its hollow side.
struct PipePieces {
  struct Cylinder {
    Vec3 from, to;  // (3) m
    double radius;  // m
  };
  std::vector<Cylinder> runs;
  std::vector<HullPoints> bends;
};
PipePieces pipe_pieces(const std::vector<SweptPipe>& pipes);

}  // namespace fulcrum::bench
