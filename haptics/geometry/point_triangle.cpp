#include "haptics/geometry/point_triangle.h"

#include <algorithm>

namespace fulcrum {
namespace {

TrianglePoint at(const Vec3& p, const Vec3& point, TriangleFeature feature) {
  return {point, (p - point).squaredNorm(), feature};
}

}  // namespace

TrianglePoint closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return at(p, a, TriangleFeature::corner0);

  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return at(p, b, TriangleFeature::corner1);

  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return at(p, a + ab * (d1 / (d1 - d3)), TriangleFeature::edge0);

  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return at(p, c, TriangleFeature::corner2);

  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return at(p, a + ac * (d2 / (d2 - d6)), TriangleFeature::edge2);

  const double va = d3 * d6 - d5 * d4;
  const double e1 = d4 - d3, e2 = d5 - d6;
  if (va <= 0.0 && e1 >= 0.0 && e2 >= 0.0)
    return at(p, b + (c - b) * (e1 / (e1 + e2)), TriangleFeature::edge1);
  const double scale = 1.0 / (va + vb + vc);
  return at(p, a + ab * (vb * scale) + ac * (vc * scale), TriangleFeature::face);
}

bool is_sliver(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kThin = 1e-6;  // height over length
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() < kThin * longest;
}

}  // namespace fulcrum
