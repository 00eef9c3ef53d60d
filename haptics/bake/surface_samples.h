#pragma once
// Many points spread over a surface in proportion to its area, in an order without pattern.

#include <cstdint>
#include <vector>

#include "haptics/bake/sharp_features.h"

namespace fulcrum {

struct SurfaceSamples {
  std::vector<SurfacePoint> points;  // with the normal of their triangle
  std::vector<double> areas_m2;      // (n) m^2 each stands for; every triangle's own sum to its area
};

// One sample for about every area_m2 of surface and at least one for every triangle. Same seed, same samples.
SurfaceSamples sample_surface(const TriangleMesh& mesh, double area_m2, std::uint64_t seed);

double surface_area(const TriangleMesh& mesh);  // m^2

}  // namespace fulcrum
