#pragma once
// The contact benchmark's workload: the ring spanner sliding through the plant's pipes, shallowly in contact.
// The same for Fulcrum and for the libraries it is compared with.

#include <vector>

#include "haptics/bake/solid.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"
#include "tests/bench/deepest_point.h"
#include "tests/bench/swept_pipes.h"

namespace fulcrum::bench {

inline constexpr double kPenetration = 0.8e-3;   // m
inline constexpr double kDepthTolerance = 2e-6;  // m, of the truth that depths are compared with

struct Workload {
  std::vector<SweptPipe> pipes;
  Solid scene;  // the pipes, about 117 000 triangles
  Solid tool;   // the spanner, about 18 000 triangles, origin at its centre of mass
  DeepestPoint truth;
};
Workload make_workload();

Solid one_pipe(const Workload& workload);
Solid whole_plant();  // pipes with beads, flanges, bolts, frame: what the piping scenario loads

// Exactly n points at random, evenly over the tool's surface.
Pointshell shell_of(const Solid& tool, std::size_t n);

// Poses at which the deepest point of the tool's surface lies kPenetration deep, give or take 1 %: slides of
// a hundred poses, half a millimetre and half a degree from one to the next, as a tool moves. Same seed, same
// poses.
std::vector<Pose> touching_poses(const Workload& workload, std::size_t n, unsigned seed);

}  // namespace fulcrum::bench
