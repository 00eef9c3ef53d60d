#include "haptics/bake/surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {
namespace {

// SplitMix64, G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators" (OOPSLA 2014).
// The standard library's distributions may differ from one library to the next; this does not.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // in [0, 1)

private:
  std::uint64_t state_;
};

std::array<Vec3, 3> corners(const TriangleMesh& mesh, const Triangle& triangle) {
  return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
}

}  // namespace

SurfaceSamples sample_surface(const TriangleMesh& mesh, double area_m2, std::uint64_t seed) {
  SurfaceSamples samples;
  Random random(seed);
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c] = corners(mesh, triangle);
    const Vec3 cross = (b - a).cross(c - a);
    const double area = 0.5 * cross.norm();
    if (area == 0.0) continue;
    const auto count = static_cast<std::size_t>(std::ceil(area / area_m2));
    for (std::size_t i = 0; i < count; ++i) {
      // One sample in each of `count` strips of equal area, at random along the strip.
      const double s = std::sqrt((static_cast<double>(i) + random.unit()) / static_cast<double>(count));
      const double t = random.unit();
      samples.points.push_back({a + s * ((1.0 - t) * (b - a) + t * (c - a)), cross.normalized()});
      samples.areas_m2.push_back(area / static_cast<double>(count));
    }
  }
  for (std::size_t i = samples.points.size(); i > 1; --i) {  // Fisher and Yates' shuffle
    const std::size_t j = random.bits() % i;
    std::swap(samples.points[i - 1], samples.points[j]);
    std::swap(samples.areas_m2[i - 1], samples.areas_m2[j]);
  }
  return samples;
}

double surface_area(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c] = corners(mesh, triangle);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

}  // namespace fulcrum
