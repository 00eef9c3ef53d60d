#include "tools/content/knock/bench.h"

#include "tools/content/knock/pegs.h"
#include "tools/content/mesh/loft.h"

namespace fulcrum::content {

Model make_bench() {
  Model model{.name = "bench",
              .materials = {{.name = "worktop",
                             .base_colour = {0.075, 0.09, 0.105},
                             .metallic = 0.0,
                             .roughness = 0.42}},
              .parts = {}};
  const Eigen::Vector3d half(0.75, 15.0 * mm, 0.55);
  const Eigen::Isometry3d X(Eigen::Translation3d(0.0, bench_height - half.y(), -0.15));
  model.parts.push_back(
      {.name = "worktop", .material = 0, .solid = transformed(chamfered_box(half, 3.0 * mm), X)});
  return model;
}

}  // namespace fulcrum::content
