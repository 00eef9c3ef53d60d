#include "haptics/bake/pointshell_bake.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/bake/covering.h"
#include "haptics/bake/curvature_refinement.h"
#include "haptics/bake/point_grid.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/sharp_features.h"
#include "haptics/bake/surface_samples.h"

namespace fulcrum {
namespace {

constexpr double kMaxPoints = 4e6;
constexpr double kSamplesPerPoint = 32.0;
// Random discs that keep a distance r and leave no gap number .697/r^2 per area (jamming at 54.7 % of the
// plane, E. L. Hinrichsen, J. Feder, T. Jossang, J. Stat. Phys. 44, 1986). At this many spacings they number
// as the triangular lattice of that spacing.
constexpr double kDiscSpacings = 0.777;
constexpr double kPointsPerSpacingSquared = 1.1547;  // of the triangular lattice, 2/sqrt(3)
// Points of surfaces that face more than 72 degrees apart do not crowd each other: the two sides of a thin
// plate.
constexpr double kSameSide = 0.3;

auto facing(const Vec3& normal) {
  return [normal](const SurfacePoint& point) { return point.normal.dot(normal) > kSameSide; };
}

std::optional<Error> check_spacing(double spacing) {
  if (spacing > 0.0 && std::isfinite(spacing)) return std::nullopt;
  return Error{"A pointshell's spacing must be a positive length, not " + spell(spacing) +
               " m: 0.0015 suits hand tools."};
}

Result<Pointshell> shell_of(const std::vector<SurfacePoint>& points, std::span<const double> areas,
                            double covering_radius) {
  std::vector<Vec3> positions, normals;
  for (const SurfacePoint& point : points) {
    positions.push_back(point.position);
    normals.push_back(point.normal);
  }
  return pointshell_from_points(positions, normals, areas, covering_radius);
}

}  // namespace

Result<Pointshell> bake_pointshell(const Solid& solid, const PointshellDesc& desc) {
  if (std::optional<Error> error = check_spacing(desc.spacing_m)) return *error;
  if (!(desc.deviation > 0.0)) {
    return Error{"A pointshell's deviation must be a positive length, not " + spell(desc.deviation) +
                 " m: 0.00005 suits hand tools."};
  }
  const double spacing_squared = desc.spacing_m * desc.spacing_m;
  const double area = surface_area(solid.mesh);
  const double expected = kPointsPerSpacingSquared * area / spacing_squared;
  if (expected > kMaxPoints) {
    return Error{"A pointshell with " + spell_mm(desc.spacing_m) + " spacing would have about " +
                 spell(expected) + " points: use a spacing of " +
                 spell_mm(1.05 * desc.spacing_m * std::sqrt(expected / kMaxPoints)) + " or more."};
  }

  // Corners and sharp edges first, then darts: a sample becomes a point where no point is near.
  PointGrid grid(desc.spacing_m);
  for (const SurfacePoint& point : sharp_points(solid, desc.sharp_angle_rad, desc.spacing_m)) grid.add(point);
  const SurfaceSamples samples =
      sample_surface(solid.mesh, spacing_squared / (kPointsPerSpacingSquared * kSamplesPerPoint), desc.seed);
  for (const SurfacePoint& sample : samples.points) {
    const auto near = grid.nearest(sample.position, kDiscSpacings * desc.spacing_m, facing(sample.normal));
    if (near.index == PointGrid::kNone) grid.add(sample);
  }

  if (std::isfinite(desc.deviation) && !refine_by_curvature(solid, samples, desc.deviation, desc.spacing_m,
                                                            static_cast<std::size_t>(kMaxPoints), grid)) {
    return Error{"A pointshell from which the surface stands out by at most " + spell_mm(desc.deviation) +
                 " would have more than " + spell(kMaxPoints) + " points: allow a larger deviation."};
  }

  // Each sample's area goes to the nearest point that faces its way, which no farther than its own disc there
  // is.
  std::vector<double> areas(grid.points().size(), 0.0);
  double seen = 0.0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const SurfacePoint& sample = samples.points[i];
    areas[grid.nearest(sample.position, desc.spacing_m, facing(sample.normal)).index] += samples.areas_m2[i];
    seen = std::max(
        seen,
        grid.nearest(sample.position, desc.spacing_m, [](const SurfacePoint&) { return true; }).distance);
  }

  return shell_of(grid.points(), areas, covering_radius(solid, grid, seen));
}

Result<Pointshell> bake_edges(const Solid& solid, const PointshellDesc& desc) {
  if (std::optional<Error> error = check_spacing(desc.spacing_m)) return *error;
  const std::vector<SurfacePoint> points =
      sharp_points(solid, desc.sharp_angle_rad, desc.spacing_m, SharpEdgeKind::convex);
  if (points.empty()) return Error{"there is no sharp edge: leave edges out."};
  if (static_cast<double>(points.size()) > kMaxPoints) {
    return Error{"points " + spell_mm(desc.spacing_m) + " apart would be " +
                 spell(static_cast<double>(points.size())) + ": put them farther apart."};
  }
  return shell_of(points, std::vector<double>(points.size(), 0.0), 0.0);  // it covers no surface
}

}  // namespace fulcrum
