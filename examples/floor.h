#pragma once
// A scene of one floor and one point, for the examples: from meshes to what World::build() takes.

#include <memory>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/world/world.h"

// Below y = 0, 0.2 m wide; the tool is a point at the handle, 5 mm above.
inline fulcrum::Result<fulcrum::SceneDesc> floor_and_point() {
  using namespace fulcrum;
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? 0.1 : -0.1, i & 2 ? 0.0 : -0.04, i & 4 ? 0.1 : -0.1);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const Result<Solid> solid = build_solid(mesh);
  if (!solid) return solid.error();
  Result<DistanceField> field = bake_field(*solid, FieldDesc{.voxel_m = 2e-3, .band_m = 10e-3});
  if (!field) return field.error();
  const std::vector<Vec3> points{Vec3::Zero()}, normals{-Vec3::UnitY()};
  Result<Pointshell> shell = pointshell_from_points(points, normals, std::vector<double>{1e-6}, 0);
  if (!shell) return shell.error();

  SceneDesc scene;
  scene.scene_field = std::make_shared<const DistanceField>(std::move(*field));
  scene.tool_shell = std::make_shared<const Pointshell>(std::move(*shell));
  scene.tool.mass = 0.2;
  scene.tool.inertia_T = Mat3::Identity() * 5e-5;
  scene.tool.weight = false;
  scene.tool.X_WT_start.p = Vec3(0, 5e-3, 0);
  scene.contact.response = ContactResponse::constraint;
  return scene;
}
