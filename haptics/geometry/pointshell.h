#pragma once
// A tool's surface as points: what is looked up in the scene's distance field. After McNeely, Puterbaugh and
// Troy, "Six degree-of-freedom haptic rendering using voxel sampling" (SIGGRAPH 1999), with area weights.

#include <cstddef>
#include <span>
#include <vector>

#include "haptics/math/pose.h"
#include "haptics/math/result.h"

namespace fulcrum {

// Structure of arrays, in kd order: any aligned run of 16 points is a compact patch.
struct Pointshell {
  std::vector<Vec3> positions;   // p_T (n x 3) m
  std::vector<Vec3> normals;     // nhat_T (n x 3) unit, outward
  std::vector<double> areas_m2;  // (n) m^2, the surface each point stands for; they sum to the surface's area
  double covering_radius_m = 0.0;  // no point of the surface is farther than this from a shell point
  double max_radius_m = 0.0;       // largest |p_T|: how far the tool reaches from T

  std::size_t size() const { return positions.size(); }
};

// A shell of given points: corners, single probes. Sorted like any other; normals are made unit.
// Refused: no points, lengths that differ, a number that is not finite, a zero normal, a negative area.
Result<Pointshell> pointshell_from_points(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                          std::span<const double> areas_m2, double covering_radius_m);

// The same shell seen from another frame: X_TM is the pose of the shell's frame M in T.
Pointshell transformed(const Pointshell& shell_M, const Pose& X_TM);

}  // namespace fulcrum
