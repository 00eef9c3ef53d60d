#include "engine/importing/simplify.h"

#include <meshoptimizer.h>

#include <limits>
#include <utility>

namespace fulcrum::importing {
namespace {

// Only the corners that are still used, in the order in which triangles name them.
void drop_unused(ModelPart& part) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(part.positions.size(), kUnused);
  ModelPart kept;
  for (std::uint32_t& index : part.indices) {
    if (place[index] == kUnused) {
      place[index] = static_cast<std::uint32_t>(kept.positions.size());
      kept.positions.push_back(part.positions[index]);
      kept.normals.push_back(part.normals[index]);
      if (!part.colours.empty()) kept.colours.push_back(part.colours[index]);
    }
    index = place[index];
  }
  part.positions = std::move(kept.positions);
  part.normals = std::move(kept.normals);
  part.colours = std::move(kept.colours);
}

}  // namespace

Model simplified(const Model& model, double tolerance) {
  Model result = model;
  for (ModelPart& part : result.parts) {
    std::vector<float> positions;
    for (const Vec3& p : part.positions)
      for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(p[axis]));
    constexpr std::size_t kStride = 3 * sizeof(float);
    const float scale = meshopt_simplifyScale(positions.data(), part.positions.size(), kStride);
    if (!(scale > 0)) continue;
    std::vector<std::uint32_t> indices(part.indices.size());
    indices.resize(meshopt_simplify(indices.data(), part.indices.data(), part.indices.size(),
                                    positions.data(), part.positions.size(), kStride, 0,
                                    static_cast<float>(tolerance) / scale, 0, nullptr));
    if (indices.empty()) continue;  // all of it is smaller than the tolerance: it stays as it is
    part.indices = std::move(indices);
    drop_unused(part);
  }
  return result;
}

}  // namespace fulcrum::importing
