#include "engine/app/author/starter_models.h"

#include <array>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum::app {
namespace {

// Flat: each polygon has corners of its own.
void add_polygon(ModelPart& part, const std::vector<Vec3>& corners) {
  const auto first = static_cast<std::uint32_t>(part.positions.size());
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  for (const Vec3& corner : corners) {
    part.positions.push_back(corner);
    part.normals.push_back(normal);
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i)
    part.indices.insert(part.indices.end(), {first, first + i - 1, first + i});
}

ModelPart box(const char* name, const Vec3& low, const Vec3& high, std::uint32_t material) {
  ModelPart part;
  part.name = name;
  part.material = material;
  const auto corner = [&](int c) {
    return Vec3((c & 1) != 0 ? high.x() : low.x(), (c & 2) != 0 ? high.y() : low.y(),
                (c & 4) != 0 ? high.z() : low.z());
  };
  constexpr std::array<std::array<int, 4>, 6> kFaces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& face : kFaces)
    add_polygon(part, {corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
  return part;
}

// Turned about y, from the bottom to the top; the ends are closed.
ModelPart turned(const char* name, const std::vector<Eigen::Vector2d>& radius_and_height,
                 std::uint32_t material) {
  constexpr int kSides = 24;
  ModelPart part;
  part.name = name;
  part.material = material;
  const auto at = [&](std::size_t ring, int side) {
    const double angle = 2 * std::numbers::pi * (side % kSides) / kSides;
    const Eigen::Vector2d& p = radius_and_height[ring];
    return Vec3(p.x() * math::cos(angle), p.y(), -p.x() * math::sin(angle));
  };
  std::vector<Vec3> bottom, top;
  for (int side = 0; side < kSides; ++side) {
    bottom.insert(bottom.begin(), at(0, side));
    top.push_back(at(radius_and_height.size() - 1, side));
    for (std::size_t ring = 0; ring + 1 < radius_and_height.size(); ++ring)
      add_polygon(part, {at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)});
  }
  add_polygon(part, bottom);
  add_polygon(part, top);
  return part;
}

}  // namespace

Model starter_board() {
  return {.parts = {box("board", {-0.08, -0.02, -0.06}, {0.08, 0, 0.06}, 0),
                    box("step", {-0.025, -0.01, -0.025}, {0.025, 0.015, 0.025}, 1)},
          .materials = {{.name = "board", .base_colour = {0.30F, 0.20F, 0.12F}, .roughness = 0.7F},
                        {.name = "step", .base_colour = {0.10F, 0.28F, 0.40F}, .roughness = 0.45F}}};
}

Model starter_pin() {
  return {.parts = {turned("pin", {{0.001, 0}, {0.0025, 0.012}, {0.005, 0.05}, {0.005, 0.11}}, 0)},
          .materials = {
              {.name = "steel", .base_colour = {0.62F, 0.62F, 0.60F}, .metallic = 0.6F, .roughness = 0.4F}}};
}

}  // namespace fulcrum::app
