#pragma once
// Meshes of bodies whose distance is known in closed form.

#include <span>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum::analysis {

// A ball about the origin; vertices on the sphere, splits^2 * 20 triangles (a power of two).
TriangleMesh ball_mesh(double radius, int splits);

// A tube along z about the origin: inner and outer radius, length, all m; `sides` facets a turn whose middles
// are as much inside the circle as their corners are outside.
TriangleMesh tube_mesh(double inner, double outer, double length, int sides);

TriangleMesh box_mesh(const Vec3& low, const Vec3& high);

TriangleMesh moved(TriangleMesh mesh, const Pose& X);
TriangleMesh joined(std::span<const TriangleMesh> meshes);

}  // namespace fulcrum::analysis
