#pragma once
// The contact benchmark's workload: the ring spanner sliding through the plant's pipes, shallowly in contact.

#include <memory>
#include <vector>

#include "haptics/bake/solid.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"

namespace fulcrum::bench {

inline constexpr double kPenetration = 0.8e-3;  // m

Solid spanner();   // at least 20 000 triangles, origin at its centre of mass
Solid piping();    // at least 100 000 triangles
Solid one_pipe();  // of piping()

// Exactly n points, evenly over the tool's surface.
Pointshell shell_of(const Solid& tool, std::size_t n);

// Poses at which the deepest point lies about kPenetration deep: slides of a hundred poses, half a millimetre
// and half a degree from one to the next, as a tool moves. Same seed, same poses.
std::vector<Pose> touching_poses(const DistanceField& field, const Pointshell& shell, std::size_t n,
                                 unsigned seed);

}  // namespace fulcrum::bench
