#include "engine/render/bounds.h"

namespace fulcrum::render {

Bounds bounds_of(std::span<const glm::vec3> positions) {
  Bounds bounds{positions.front(), positions.front()};
  for (const glm::vec3& position : positions) bounds = united(bounds, {position, position});
  return bounds;
}

std::array<glm::vec3, 8> corners(const Bounds& bounds) {
  std::array<glm::vec3, 8> points;
  for (std::size_t i = 0; i < 8; ++i)
    points[i] = {(i & 1) != 0 ? bounds.high.x : bounds.low.x, (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                 (i & 4) != 0 ? bounds.high.z : bounds.low.z};
  return points;
}

Bounds transformed(const Bounds& bounds, const glm::mat4& X) {
  std::array<glm::vec3, 8> points = corners(bounds);
  for (glm::vec3& point : points) point = glm::vec3(X * glm::vec4(point, 1.0F));
  return bounds_of(points);
}

Bounds united(const Bounds& a, const Bounds& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

}  // namespace fulcrum::render
