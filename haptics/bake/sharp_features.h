#pragma once
// Edges and corners of a solid that a shell of evenly spread points would round off.
// A convex edge can go in between another body's points; one in a groove cannot.

#include <vector>

#include "haptics/bake/solid.h"

namespace fulcrum {

struct SurfacePoint {
  Vec3 position = Vec3::Zero();  // (3) m
  Vec3 normal = Vec3::UnitY();   // (3) unit, outward; on an edge or corner the mean of the faces'
};

// Points on edges whose faces' normals differ by more than sharp_angle_rad: first the corners, where such
// edges end, meet or turn by more than that angle; then points at most spacing_m apart along the edges
// between them.
enum class SharpEdgeKind { any, convex };
std::vector<SurfacePoint> sharp_points(const Solid& solid, double sharp_angle_rad, double spacing_m,
                                       SharpEdgeKind kind = SharpEdgeKind::any);

}  // namespace fulcrum
