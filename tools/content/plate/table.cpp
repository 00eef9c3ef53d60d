#include "tools/content/plate/table.h"

#include <cmath>
#include <utility>

#include "tools/content/mesh/loft.h"
#include "tools/content/plate/stand.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double pitch = 25.0 * mm;  // of the threaded holes
constexpr int columns = 51;
constexpr int rows = 37;
const Vector3d middle(-12.5 * mm, bench_height, -75.0 * mm);

// A flat disc for each hole, a little above the table's face: what is not touched need not be a hole.
Solid discs(double radius, double height) {
  constexpr int corners = 14;
  Solid all;
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const Vector3d at = middle + pitch * Vector3d(i - 0.5 * (columns - 1), 0.0, k - 0.5 * (rows - 1));
      const RadiusHeight profile[] = {{radius, -0.5 * mm}, {radius, height}};
      const Solid disc = transformed(lathe(profile, corners), frame_along(at, Vector3d::UnitY()));
      const auto first = static_cast<std::uint32_t>(all.points.size());
      all.points.insert(all.points.end(), disc.points.begin(), disc.points.end());
      for (const Triangle& t : disc.triangles) all.add_triangle(t[0] + first, t[1] + first, t[2] + first);
    }
  }
  return all;
}

}  // namespace

Model make_table() {
  Model model{
      .name = "table",
      .materials =
          {{.name = "table", .base_colour = {0.19, 0.2, 0.21}, .metallic = 0.35, .roughness = 0.5},
           {.name = "countersink", .base_colour = {0.55, 0.55, 0.55}, .metallic = 0.6, .roughness = 0.4},
           {.name = "hole", .base_colour = {0.012, 0.012, 0.012}, .metallic = 0.0, .roughness = 0.9}},
      .parts = {}};
  const Vector3d half(0.5 * columns * pitch, 30.0 * mm, 0.5 * rows * pitch);
  const Eigen::Isometry3d X(Eigen::Translation3d(middle - half.y() * Vector3d::UnitY()));
  model.parts.push_back(
      {.name = "slab", .material = 0, .solid = transformed(chamfered_box(half, 3.0 * mm), X)});
  model.parts.push_back({.name = "countersinks", .material = 1, .solid = discs(3.9 * mm, 0.08 * mm)});
  model.parts.push_back({.name = "holes", .material = 2, .solid = discs(3.1 * mm, 0.16 * mm)});
  return model;
}

}  // namespace fulcrum::content
