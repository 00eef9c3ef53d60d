#pragma once
// The distance to a union of components near one place: only those components are asked that can be the
// nearest there, each from the triangle that was nearest last time. Exact: what is left out is left out
// because the distance is 1-Lipschitz.

#include <cstdint>
#include <vector>

#include "haptics/bake/triangle_distance.h"

namespace fulcrum {

class UnionDistance {
public:
  // Everything that can be nearest within `radius` of `centre`.
  UnionDistance(const TriangleDistance& exact, const Solid& solid, const Vec3& centre, double radius);
  // What of `parent` can be nearest within a smaller ball inside the parent's.
  UnionDistance(const UnionDistance& parent, const Vec3& centre, double radius);

  double at_centre() const { return at_centre_; }  // m, signed
  double operator()(const Vec3& p);                // m, signed; p within radius of centre
  // Like that, with the closest point of the surface.
  double closest(const Vec3& p, Vec3& point);

private:
  struct Candidate {
    std::uint32_t component;
    std::uint32_t hint;  // the triangle nearest to `asked`
    double distance;     // m, signed, from `asked`
    Vec3 asked;
  };
  std::size_t ask(const Vec3& p);  // the candidate with the smallest distance
  void keep_near(double radius);

  const TriangleDistance* exact_;
  std::vector<Candidate> candidates_;
  std::size_t last_ = 0;  // the candidate that was nearest last time
  double at_centre_ = 0.0;
};

}  // namespace fulcrum
