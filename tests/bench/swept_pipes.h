#pragma once
// The plant's pipes as swept circles: a shape whose distance is known in closed form, of which the mesh that
// is baked and the hulls that are cut are approximations.

#include <variant>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum::bench {

// A straight length of centreline. An open end is a flat disc; elsewhere the pipe goes on.
struct Run {
  Vec3 from, to;  // (3) m
  bool open_from, open_to;
};

// A bend: centre + radius (cos(a) arm + sin(a) tangent), a from 0 to angle.
struct Bend {
  Vec3 centre;        // (3) m
  Vec3 arm, tangent;  // (3) unit, both where the bend starts
  double radius;      // m, of the centreline
  double angle;       // rad
};

struct SweptPipe {
  double radius;                               // m
  std::vector<std::variant<Run, Bend>> parts;  // in order
  Box3 bounds;                                 // m
};

// The 14 lines of the piping scenario, without beads, flanges and what holds them.
std::vector<SweptPipe> plant_pipes();

struct Nearest {
  double distance;   // m, negative inside, exact
  Vec3 normal;       // (3) unit, its gradient
  double bend;       // 1/m, most by which the distance to that pipe curves downwards nearby
  double runner_up;  // m, at most the distance to any other pipe
};
// To the nearest pipe, or to the one in which the point lies deepest.
Nearest nearest_pipe(const std::vector<SweptPipe>& pipes, const Vec3& p);

// A closed surface for each pipe. Its corners lie so far outside the circle that its faces stray as far to
// one side of it as to the other.
TriangleMesh mesh_of(const std::vector<SweptPipe>& pipes);

}  // namespace fulcrum::bench
