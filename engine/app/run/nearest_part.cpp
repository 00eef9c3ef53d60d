#include "engine/app/run/nearest_part.h"

#include <limits>

#include "haptics/geometry/point_triangle.h"

namespace fulcrum::app {
namespace {

double squared_distance(const ModelPart& part, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const TrianglePoint nearest =
        closest_on_triangle(p, part.positions[part.indices[i]], part.positions[part.indices[i + 1]],
                            part.positions[part.indices[i + 2]]);
    least = std::min(least, (nearest.point - p).squaredNorm());
  }
  return least;
}

}  // namespace

std::string nearest_part(const scenario::Scenario& scenario, const scenario::LoadedModels& models,
                         const Vec3& p_W) {
  std::string name;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scenario.models.size(); ++i) {
    if (scenario.models[i].role != scenario::ModelRole::scene) continue;
    for (const ModelPart& part : models.models[i].parts) {
      const double squared = squared_distance(part, p_W);
      if (squared >= least) continue;
      least = squared;
      name = scenario.models[i].file.path.filename().string();
      if (!part.name.empty()) name += ": " + part.name;
    }
  }
  return name;
}

}  // namespace fulcrum::app
