#include "haptics/bake/mirrored.h"

#include <algorithm>
#include <utility>

#include "haptics/math/mirror.h"

namespace fulcrum {
namespace {

Box3 mirrored(const Box3& box) {
  if (box.isEmpty()) return box;
  Box3 image = box;
  negate(image.min().x());
  negate(image.max().x());
  std::swap(image.min().x(), image.max().x());
  return image;
}

// Each run of `count` values along x, the other way about.
template <class Values>
void reverse_runs(Values& values, std::size_t count) {
  for (auto run = values.begin(); run != values.end(); run += static_cast<std::ptrdiff_t>(count))
    std::reverse(run, run + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

TriangleMesh mirrored(TriangleMesh mesh) {
  for (Vec3& vertex : mesh.vertices) mirror(vertex);
  for (Triangle& corner : mesh.triangles) std::swap(corner[1], corner[2]);
  return mesh;
}

Solid mirrored(Solid solid) {
  solid.mesh = mirrored(std::move(solid.mesh));
  for (Triangle& across : solid.neighbours) std::swap(across[0], across[2]);  // edge ab is now ca
  for (SolidComponent& component : solid.components) {
    component.bounds = mirrored(component.bounds);
    component.shell = mirrored(std::move(component.shell));
  }
  return solid;
}

MassProperties mirrored(MassProperties of) {
  mirror(of.centre);
  for (const Eigen::Index axis : {1, 2}) {
    negate(of.inertia(0, axis));
    negate(of.inertia(axis, 0));
  }
  return of;
}

Pointshell mirrored(Pointshell shell) {
  for (Vec3& p : shell.positions) mirror(p);
  for (Vec3& n : shell.normals) mirror(n);
  return shell;
}

DistanceField mirrored(const DistanceField& field) {
  FieldData image = field.data();
  image.origin.x() = -field.grid_box().max().x();
  image.surface_box = mirrored(image.surface_box);
  const auto bricks = static_cast<std::size_t>(image.bricks[0]);
  reverse_runs(image.brick_slot, bricks);
  reverse_runs(image.centre_m, bricks);
  reverse_runs(image.values_float, kBrickSide);
  reverse_runs(image.values_int16, kBrickSide);
  return DistanceField(std::move(image));
}

}  // namespace fulcrum
