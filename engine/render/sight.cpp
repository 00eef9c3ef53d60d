#include "engine/render/sight.h"

#include <algorithm>

namespace fulcrum::render {

bool Sight::sees(const Bounds& box) const {
  std::array<glm::vec4, 8> at{};
  std::ranges::transform(
      corners(box), at.begin(),
      [this](const glm::vec3& corner) { return clip_from_world * glm::vec4(corner, 1.0F); });
  const auto all = [&at](auto is_beyond) { return std::ranges::all_of(at, is_beyond); };
  return !all([](const glm::vec4& p) { return p.x < -p.w; }) &&
         !all([](const glm::vec4& p) { return p.x > p.w; }) &&
         !all([](const glm::vec4& p) { return p.y < -p.w; }) &&
         !all([](const glm::vec4& p) { return p.y > p.w; }) &&
         !all([](const glm::vec4& p) { return p.z < 0.0F; }) &&
         !all([](const glm::vec4& p) { return p.z > p.w; });
}

float Sight::distance(const Bounds& box) const {
  return glm::distance(eye, glm::clamp(eye, box.low, box.high));
}

}  // namespace fulcrum::render
