#include "engine/render/octahedral_map.h"

#include <cmath>

namespace fulcrum::render {
namespace {

constexpr float kInside = 0.75F;  // of the side: the rest is border

// The unit direction of a place on the map, -1..1; a little beyond, the one beyond the fold.
glm::vec3 direction_at(glm::vec2 p) {
  if (std::abs(p.x) > 1.0F) p = {std::copysign(2.0F, p.x) - p.x, -p.y};
  if (std::abs(p.y) > 1.0F) p = {-p.x, std::copysign(2.0F, p.y) - p.y};
  const float y = 1.0F - std::abs(p.x) - std::abs(p.y);
  glm::vec2 flat = p;
  if (y < 0.0F) flat = {std::copysign(1.0F - std::abs(p.y), p.x), std::copysign(1.0F - std::abs(p.x), p.y)};
  return glm::normalize(glm::vec3(flat.x, y, flat.y));
}

glm::vec2 place_of(const glm::vec3& d) {
  const glm::vec3 on = d / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
  if (on.y >= 0.0F) return {on.x, on.z};
  return {std::copysign(1.0F - std::abs(on.z), on.x), std::copysign(1.0F - std::abs(on.x), on.z)};
}

}  // namespace

glm::vec3 OctahedralMap::direction(std::uint32_t column, std::uint32_t row) const {
  const glm::vec2 middle(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
  return direction_at((middle * (2.0F / static_cast<float>(side)) - 1.0F) / kInside);
}

std::size_t OctahedralMap::index(const glm::vec3& d) const {
  const std::uint32_t border = side / 8;
  const auto first = static_cast<float>(border), last = static_cast<float>(side - border - 1);
  const glm::vec2 p = (place_of(d) * (0.5F * kInside) + 0.5F) * static_cast<float>(side);
  const glm::vec2 pixel = glm::clamp(glm::floor(p), first, last);
  return static_cast<std::size_t>(pixel.y) * side + static_cast<std::size_t>(pixel.x);
}

glm::vec3 OctahedralMap::at(const glm::vec3& d) const {
  const glm::vec2 p = (place_of(d) * (0.5F * kInside) + 0.5F) * static_cast<float>(side) - 0.5F;
  const glm::vec2 low = glm::floor(p), part = p - low;
  const auto column = static_cast<std::size_t>(low.x), row = static_cast<std::size_t>(low.y);
  const glm::vec3* first = pixels.data() + row * side + column;
  return glm::mix(glm::mix(first[0], first[1], part.x), glm::mix(first[side], first[side + 1], part.x),
                  part.y);
}

}  // namespace fulcrum::render
