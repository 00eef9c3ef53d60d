#include "tools/content/mesh/worktop.h"

#include "tools/content/mesh/loft.h"

namespace fulcrum::content {

Model make_worktop(const Eigen::Vector3d& top_W) {
  Model model{.name = "bench",
              .materials = {{.name = "worktop",
                             .base_colour = {0.105, 0.115, 0.125},
                             .metallic = 0.0,
                             .roughness = 0.5}},
              .parts = {}};
  constexpr double thickness = 30.0 * mm;
  const Eigen::Vector3d half(0.75, 0.5 * thickness, 0.55);
  const Eigen::Isometry3d X(Eigen::Translation3d(top_W - half.y() * Eigen::Vector3d::UnitY()));
  model.parts.push_back(
      {.name = "worktop", .material = 0, .solid = transformed(chamfered_box(half, 3.0 * mm), X)});
  return model;
}

}  // namespace fulcrum::content
