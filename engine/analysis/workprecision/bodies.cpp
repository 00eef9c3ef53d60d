#include "engine/analysis/workprecision/bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/bake/solid.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::workprecision {

std::shared_ptr<const DistanceField> field_of(const TriangleMesh& mesh, double voxel, FieldFormat format) {
  const Result<Solid> solid = build_solid(mesh);
  FieldDesc desc;
  desc.voxel_m = voxel;
  desc.band_m = std::max(3 * voxel, 2.5e-3);
  desc.format = format;
  return std::make_shared<DistanceField>(std::move(*bake_field(*solid, desc)));
}

std::vector<std::shared_ptr<const DistanceField>> fields_of(const TriangleMesh& mesh,
                                                            std::span<const double> voxels_mm) {
  std::vector<std::shared_ptr<const DistanceField>> fields;
  for (const double voxel_mm : voxels_mm) fields.push_back(field_of(mesh, 1e-3 * voxel_mm));
  return fields;
}

std::shared_ptr<const FeatureMesh> features_of(const TriangleMesh& mesh) {
  const Result<Solid> solid = build_solid(mesh);
  return std::make_shared<FeatureMesh>(solid->mesh, solid->neighbours);
}

Vec3 random_direction(std::mt19937_64& random) {
  std::uniform_real_distribution<double> along(-1, 1);
  while (true) {
    const double x = along(random), y = along(random), z = along(random);
    const double length = Vec3(x, y, z).norm();
    if (length > 0.1 && length < 1) return Vec3(x, y, z) / length;
  }
}

double golden_angle(int i) {
  return std::remainder(2 * std::numbers::pi * std::numbers::phi * i, 2 * std::numbers::pi);
}

std::vector<Vec3> fibonacci_sphere(int count) {
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - y * y);
    directions.emplace_back(r * math::cos(golden_angle(i)), y, r * math::sin(golden_angle(i)));
  }
  return directions;
}

std::shared_ptr<const Pointshell> shell_touching(std::span<const Vec3> touching,
                                                 std::span<const Vec3> outward, double inside) {
  std::vector<Vec3> points(touching.begin(), touching.end()), normals(outward.begin(), outward.end());
  for (const Vec3& u : fibonacci_sphere(kShellPoints - static_cast<int>(touching.size()))) {
    points.push_back(inside * u);
    normals.push_back(u);
  }
  return std::make_shared<Pointshell>(
      std::move(*pointshell_from_points(points, normals, std::vector<double>(points.size(), 1e-6), 0)));
}

std::shared_ptr<const Pointshell> ball_shell(double radius, double spacing) {
  const double area = 4 * std::numbers::pi * radius * radius;
  const std::vector<Vec3> u = fibonacci_sphere(static_cast<int>(std::lround(area / (spacing * spacing))));
  std::vector<Vec3> points;
  for (const Vec3& each : u) points.push_back(radius * each);
  return std::make_shared<Pointshell>(std::move(*pointshell_from_points(
      points, u, std::vector<double>(u.size(), area / static_cast<double>(u.size())), spacing)));
}

}  // namespace fulcrum::analysis::workprecision
