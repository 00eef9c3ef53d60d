#include "tools/content/plate/table.h"

#include "tools/content/mesh/loft.h"
#include "tools/content/plate/stand.h"
#include "tools/content/plate/table_face.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr int columns = 51;  // of holes
constexpr int rows = 37;
constexpr int repeats_after = 4;  // holes
const Vector3d middle(-12.5 * mm, bench_height, -75.0 * mm);

}  // namespace

Model make_table() {
  Model model{.name = "table",
              .materials = {{.name = "table",
                             .base_colour = {1.0, 1.0, 1.0},
                             .metallic = 1.0,
                             .roughness = 1.0,
                             .pictures = table_face(repeats_after)}},
              .parts = {}};
  const Vector3d half(0.5 * columns * hole_pitch, 30.0 * mm, 0.5 * rows * hole_pitch);
  const Eigen::Isometry3d X(Eigen::Translation3d(middle - half.y() * Vector3d::UnitY()));
  // Sides are half a pitch from the nearest holes, so that the face goes on down them without any.
  constexpr double side = repeats_after * hole_pitch;
  model.parts.push_back({.name = "slab",
                         .material = 0,
                         .solid = transformed(chamfered_box(half, 3.0 * mm), X),
                         .projections = {{.origin = middle - half,
                                          .along_u = Vector3d::UnitX() / side,
                                          .along_v = Vector3d::UnitZ() / side}}});
  return model;
}

}  // namespace fulcrum::content
