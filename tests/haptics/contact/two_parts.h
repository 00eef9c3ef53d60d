#pragma once
// Two parts with corners, grooves and a hole; and how far apart they are, found by the bake's own tree.

#include <algorithm>
#include <limits>
#include <memory>

#include "haptics/bake/triangle_distance.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/math/pose.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum {

inline std::shared_ptr<const FeatureMesh> features(const Solid& solid) {
  return std::make_shared<const FeatureMesh>(solid.mesh, solid.neighbours);
}

inline Solid ring() {
  return shapes::solid_of(shapes::torus(0.01, 0.004, 9, 6));
}

inline Solid brick() {
  return shapes::solid_of(shapes::box(Vec3(-0.003, -0.001, -0.007), Vec3(0.002, 0.001, 0.006)));
}

// m: the least distance of places on one's edges, and of its vertices, from the other; below 0: one is in it.
inline double least(const Solid& from, const Solid& to, const Pose& X_to_from, int steps = 60) {
  const TriangleDistance distance(to);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : from.mesh.triangles)
    for (std::size_t e = 0; e < 3; ++e)
      for (int i = 0; i < steps; ++i) {
        const Vec3 &a = from.mesh.vertices[t[e]], &b = from.mesh.vertices[t[(e + 1) % 3]];
        const Vec3 p = a + (b - a) * (static_cast<double>(i) / steps);
        smallest = std::min(smallest, distance.signed_distance(X_to_from * p));
      }
  return smallest;
}

}  // namespace fulcrum
