#include "tests/bench/contact_workload.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "haptics/bake/pointshell_bake.h"
#include "tools/content/piping/piping.h"
#include "tools/content/piping/spanner.h"

namespace fulcrum::bench {
namespace {

constexpr double kAdvance = 2e-3;  // m, of a tool on its way to touch
constexpr int kHalvings = 9;       // of that
constexpr double kCoarse = 4e-6;   // m

TriangleMesh mesh_of(const content::Model& model) {
  TriangleMesh mesh;
  for (const content::Part& part : model.parts) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.solid.points.begin(), part.solid.points.end());
    for (const content::Triangle& t : part.solid.triangles)
      mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return mesh;
}

Solid solid_of(const TriangleMesh& mesh) {
  Result<Solid> solid = build_solid(mesh);
  if (!solid) throw std::runtime_error(solid.error().sentence);
  return std::move(*solid);
}

}  // namespace

Workload make_workload() {
  std::vector<SweptPipe> pipes = plant_pipes();
  Solid scene = solid_of(mesh_of(pipes));
  Solid tool = solid_of(mesh_of(content::make_spanner()));
  DeepestPoint truth(tool.mesh, pipes);
  return {std::move(pipes), std::move(scene), std::move(tool), std::move(truth)};
}

Solid one_pipe(const Workload& workload) {
  return solid_of(mesh_of(std::vector<SweptPipe>{workload.pipes.front()}));
}

Solid whole_plant() {
  return solid_of(mesh_of(content::make_piping()));
}

// Area-weighted random points on the triangles, in the order and with the areas of a baked shell.
Pointshell shell_of(const Solid& tool, std::size_t n) {
  std::vector<double> up_to;
  double area = 0;
  for (const Triangle& t : tool.mesh.triangles) {
    const Vec3 &a = tool.mesh.vertices[t[0]], &b = tool.mesh.vertices[t[1]], &c = tool.mesh.vertices[t[2]];
    area += 0.5 * (b - a).cross(c - a).norm();
    up_to.push_back(area);
  }
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec3> points, normals;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = (static_cast<double>(i) + unit(random)) / static_cast<double>(n) * area;
    const auto found = std::upper_bound(up_to.begin(), up_to.end() - 1, at) - up_to.begin();
    const Triangle& t = tool.mesh.triangles[static_cast<std::size_t>(found)];
    const Vec3 &a = tool.mesh.vertices[t[0]], &b = tool.mesh.vertices[t[1]], &c = tool.mesh.vertices[t[2]];
    const double r = std::sqrt(unit(random)), s = unit(random);
    points.push_back((1 - r) * a + r * (1 - s) * b + r * s * c);
    normals.push_back((b - a).cross(c - a).normalized());
  }
  const std::vector<double> areas(n, area / static_cast<double>(n));
  Result<Pointshell> shell = pointshell_from_points(points, normals, areas, 0.0);
  if (!shell) throw std::runtime_error(shell.error().sentence);
  return std::move(*shell);
}

std::vector<Pose> touching_poses(const Workload& workload, std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto deeper = [&](double depth, const Pose& X_WT) {
    return workload.truth.deeper_than(depth, X_WT, kCoarse);
  };
  const auto direction = [&] {
    return Vec3(Vec3(normal(random), normal(random), normal(random)).normalized());
  };
  // Along `way` until it touches, then halving; false if it does not within `reach`.
  const auto advance = [&](Pose& X_WT, const Vec3& way, double reach) {
    const auto deep = [&](double by) { return deeper(kPenetration, {X_WT.q, X_WT.p + by * way}); };
    double out = 0, in = 0;
    if (deeper(0, X_WT)) return false;
    while (in < reach && !deep(in)) {
      out = in;
      in += kAdvance;
    }
    if (in >= reach) return false;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (out + in);
      (deep(middle) ? in : out) = middle;
    }
    X_WT.p += in * way;
    return true;
  };
  constexpr std::size_t kSlide = 100;
  constexpr double kStep = 0.5e-3, kTurn = 0.5 * std::numbers::pi / 180, kBack = 3e-3;
  std::vector<Pose> poses;
  const Box3 box = workload.scene.bounds();
  while (poses.size() < n) {
    Pose X_WT{Quat(normal(random), normal(random), normal(random), normal(random)).normalized(),
              Vec3::Zero()};
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      X_WT.p[axis] = box.min()[axis] + unit(random) * box.sizes()[axis];
    const Vec3 way = direction(), along = way.cross(direction()).normalized(), axis = direction();
    bool touches = advance(X_WT, way, 0.3);
    for (std::size_t i = 0; touches && i < kSlide && poses.size() < n; ++i) {
      poses.push_back(X_WT);
      X_WT.p += kStep * along - kBack * way;
      X_WT.q = (Quat(Eigen::AngleAxisd(kTurn, axis)) * X_WT.q).normalized();
      touches = advance(X_WT, way, 3 * kBack);
    }
  }
  return poses;
}

}  // namespace fulcrum::bench
