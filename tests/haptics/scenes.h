#pragma once
// Small scenes with known answers, built as any scene is: a mesh, a bake, a World.

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/world/world.h"

namespace fulcrum::test {

template <class T>
T expect(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().sentence);
  return std::move(*result);
}

// Corners low..high, wound outward.
inline TriangleMesh box_mesh(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline TriangleMesh joined(std::span<const TriangleMesh> meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) {
    const auto base = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

inline std::shared_ptr<const DistanceField> field_of(const TriangleMesh& mesh, double voxel = 2e-3,
                                                     double band = 10e-3) {
  const Solid solid = expect(build_solid(mesh));
  return std::make_shared<DistanceField>(
      expect(bake_field(solid, FieldDesc{.voxel_m = voxel, .band_m = band, .threads = 1})));
}

// A floor: everything below y = 0, .2 m wide.
inline std::shared_ptr<const DistanceField> floor_field() {
  static const auto field = field_of(box_mesh({-0.1, -0.04, -0.1}, {0.1, 0, 0.1}));
  return field;
}

inline std::shared_ptr<const Pointshell> shell_of(const std::vector<Vec3>& points) {
  std::vector<Vec3> normals;
  for (const Vec3& p : points) normals.push_back(p.norm() > 0 ? Vec3(p.normalized()) : Vec3(0, -1, 0));
  const std::vector<double> areas(points.size(), 1e-6);
  return std::make_shared<Pointshell>(expect(pointshell_from_points(points, normals, areas, 0)));
}

// A tool of 0.2 kg, as stout as a cube of 4 cm, at the origin of the handle, over the floor.
inline SceneDesc floor_scene(const std::vector<Vec3>& shell_points, double height) {
  SceneDesc desc;
  desc.tool.mass = 0.2;
  desc.tool.inertia_T = Mat3::Identity() * 5.3e-5;
  desc.tool.X_WT_start.p = Vec3(0, height, 0);
  desc.tool.weight = false;
  desc.tool_shell = shell_of(shell_points);
  desc.scene_field = floor_field();
  desc.velocity.kind = VelocityEstimatorKind::difference;
  desc.contact.response = ContactResponse::penalty;
  return desc;
}

inline DeviceSample at(const Pose& X_DH) {
  DeviceSample sample;
  sample.X_DH = X_DH;
  return sample;
}

inline std::vector<std::string> part_names(const SceneDesc& desc) {
  std::vector<std::string> names;
  for (const BuiltPart& part : expect(World::build(desc)).parts()) names.push_back(part.name);
  return names;
}

// Holds the handle still for a while and answers the last tick.
inline StepResult hold(World& world, const Pose& X_DH, int ticks) {
  StepResult result;
  for (int i = 0; i < ticks; ++i) result = step(world, at(X_DH), {});
  return result;
}

}  // namespace fulcrum::test
