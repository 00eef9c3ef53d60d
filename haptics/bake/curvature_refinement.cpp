#include "haptics/bake/curvature_refinement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kStepsPerReach = 4.0;

// Vertices and steps along edges, with the mean normal of the faces around.
std::vector<SurfacePoint> edge_candidates(const Solid& solid, double step) {
  const std::vector<Vec3>& at = solid.mesh.vertices;
  std::vector<Vec3> vertex_normals(at.size(), Vec3::Zero());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> edge_normals;
  for (const Triangle& triangle : solid.mesh.triangles) {
    const Vec3 cross = (at[triangle[1]] - at[triangle[0]]).cross(at[triangle[2]] - at[triangle[0]]);
    if (!(cross.squaredNorm() > 0.0)) continue;
    const Vec3 normal = cross.stableNormalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3], c = triangle[(i + 2) % 3];
      const Vec3 to_b = at[b] - at[a], to_c = at[c] - at[a];
      vertex_normals[a] += angle_between(to_b, to_c) * normal;
      edge_normals.try_emplace(std::minmax(a, b), Vec3::Zero()).first->second += normal;
    }
  }
  std::vector<SurfacePoint> candidates;
  const auto consider = [&candidates](const Vec3& position, const Vec3& sum) {
    if (sum.squaredNorm() > 0.0) candidates.push_back({position, sum.stableNormalized()});
  };
  for (std::size_t i = 0; i < at.size(); ++i) consider(at[i], vertex_normals[i]);
  for (const auto& [edge, sum] : edge_normals) {
    const Vec3 &from = at[edge.first], &to = at[edge.second];
    const double pieces = std::ceil((to - from).norm() / step);
    for (double i = 1.0; i < pieces; ++i) consider(from + i / pieces * (to - from), sum);
  }
  return candidates;
}

}  // namespace

bool refine_by_curvature(const Solid& solid, const SurfaceSamples& samples, double deviation, double reach,
                         std::size_t most, PointGrid& grid) {
  std::vector<SurfacePoint> candidates = edge_candidates(solid, reach / kStepsPerReach);
  candidates.insert(candidates.end(), samples.points.begin(), samples.points.end());
  const auto bulge = [&](const SurfacePoint& candidate) {
    double least = reach;
    grid.visit_within(candidate.position, reach, [&](const SurfacePoint& point) {
      least = std::min(least, candidate.normal.dot(candidate.position - point.position));
    });
    return least;
  };

  // The farthest out first. More points only ever lower a bulge, so one that is looked up anew and still
  // leads the queue is the largest of all.
  std::priority_queue<std::pair<double, std::size_t>> queue;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double out = bulge(candidates[i]);
    if (out > deviation) queue.emplace(out, i);
  }
  while (!queue.empty()) {
    const std::size_t i = queue.top().second;
    queue.pop();
    const double out = bulge(candidates[i]);
    if (!(out > deviation)) continue;
    if (!queue.empty() && out < queue.top().first) {
      queue.emplace(out, i);
      continue;
    }
    if (grid.points().size() == most) return false;
    grid.add(candidates[i]);
  }
  return true;
}

}  // namespace fulcrum
