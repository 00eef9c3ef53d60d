#include "tools/content/ear/gloss.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::content {
namespace {

constexpr int finish_columns = 64, finish_rows = 4;
constexpr double dry_roughness = 0.5, wet_roughness = 0.2;

}  // namespace

Material moist(const std::string& name) {
  Raster finish(finish_columns, finish_rows);
  for (int row = 0; row < finish_rows; ++row)
    for (int column = 0; column < finish_columns; ++column)
      finish.set(column, row,
                 {0.0, std::lerp(dry_roughness, wet_roughness, column / (finish_columns - 1.0)), 0.0});
  return {.name = name,
          .base_colour = {1.0, 1.0, 1.0},
          .metallic = 0.0,
          .roughness = 1.0,
          .pictures = Pictures{.metal_rough = std::move(finish)}};
}

CornerUv laid_by_wetness(const Solid& solid, const std::vector<double>& wetness) {
  // From the middle of the first pixel to that of the last: beyond them the picture repeats.
  const auto place = [&](std::uint32_t point) {
    const double part = std::clamp(wetness[point], 0.0, 1.0);
    return Eigen::Vector2d((0.5 + part * (finish_columns - 1)) / finish_columns, 0.5);
  };
  CornerUv uv;
  for (const Triangle& t : solid.triangles) uv.push_back({place(t[0]), place(t[1]), place(t[2])});
  return uv;
}

}  // namespace fulcrum::content
