#pragma once
// The point of a triangle that is closest to a given point, and which feature it lies on.
// Voronoi regions after C. Ericson, "Real-Time Collision Detection" (2005), section 5.1.5.

#include "haptics/math/linear.h"

namespace fulcrum {

enum class TriangleFeature : unsigned char { edge0, edge1, edge2, corner0, corner1, corner2, face };

struct TrianglePoint {
  Vec3 point = Vec3::Zero();  // (3) m
  double squared = 0.0;       // m^2, of the distance
  TriangleFeature feature = TriangleFeature::face;
};

// Edge e runs from corner e to corner e+1.
TrianglePoint closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

// So thin (a millionth of its length) that its plane and its normal are rounding.
bool is_sliver(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace fulcrum
