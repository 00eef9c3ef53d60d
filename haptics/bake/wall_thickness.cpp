#include "haptics/bake/wall_thickness.h"

#include <array>
#include <limits>
#include <vector>

#include "haptics/bake/parallel.h"

namespace fulcrum {
namespace {

constexpr double kFacing = -0.9;  // cosine between the outward normals of walls that face each other

Vec3 unit_normal(const Solid& solid, std::uint32_t triangle) {
  const Triangle& corner = solid.mesh.triangles[triangle];
  const Vec3& a = solid.mesh.vertices[corner[0]];
  return (solid.mesh.vertices[corner[1]] - a).cross(solid.mesh.vertices[corner[2]] - a).stableNormalized();
}

// The centroids of the triangle and of its three outer quarters.
std::array<Vec3, 4> places_on(const Solid& solid, std::uint32_t triangle) {
  const Triangle& corner = solid.mesh.triangles[triangle];
  const Vec3 &a = solid.mesh.vertices[corner[0]], &b = solid.mesh.vertices[corner[1]],
             &c = solid.mesh.vertices[corner[2]];
  return {(a + b + c) / 3.0, (4.0 * a + b + c) / 6.0, (a + 4.0 * b + c) / 6.0, (a + b + 4.0 * c) / 6.0};
}

}  // namespace

ThinSpot thinnest_wall(const Solid& solid, const TriangleDistance& exact, unsigned threads) {
  std::vector<ThinSpot> thinnest(solid.components.size());
  const auto measure = [&](std::size_t k) {
    const SolidComponent& component = solid.components[k];
    const double across = component.bounds.diagonal().norm();
    const double lift = 1e-7 * across;  // off the wall the ray starts from
    ThinSpot& spot = thinnest[k];
    spot.thickness_m = across;
    for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
         ++t) {
      const Vec3 n = unit_normal(solid, t);
      for (const Vec3& place : places_on(solid, t)) {
        const Vec3 from = place - lift * n;
        const auto hit =
            exact.first_crossing_of(static_cast<std::uint32_t>(k), from, place - spot.thickness_m * n);
        if (!hit || hit->entering || unit_normal(solid, hit->triangle).dot(n) > kFacing) continue;
        const double thickness = lift + hit->fraction * (spot.thickness_m - lift);
        if (thickness >= spot.thickness_m) continue;
        // A washer on a flange is as thick as both: a face that another component covers is no face of the
        // union.
        const Vec3 outside_here = place + lift * n, outside_there = place - (thickness + lift) * n;
        if (exact.signed_distance(outside_here) < 0.0 || exact.signed_distance(outside_there) < 0.0) continue;
        spot = {thickness, place};
      }
    }
  };
  for_each_piece(thinnest.size(), threads, measure, {});
  ThinSpot result{std::numeric_limits<double>::infinity(), Vec3::Zero()};
  for (const ThinSpot& spot : thinnest)
    if (spot.thickness_m < result.thickness_m) result = spot;
  return result;
}

}  // namespace fulcrum
