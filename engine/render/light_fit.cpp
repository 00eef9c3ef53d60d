#include "engine/render/light_fit.h"

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <limits>

namespace fulcrum::render {
namespace {

// A size that only changes in steps of an eighth of its power of two.
float rounded_up(float size) {
  const float step = std::exp2(std::floor(std::log2(std::max(size, 1e-6F)))) / 8.0F;
  return std::ceil(size / step) * step;
}

glm::mat4 look_along(const glm::vec3& eye, const glm::vec3& direction) {
  const glm::vec3 up =
      std::abs(direction.y) > 0.99F ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  return glm::lookAt(eye, eye + direction, up);
}

// The box around all of them, in that view.
Bounds seen_in(const glm::mat4& view, std::span<const Bounds> casters) {
  Bounds seen = transformed(casters.front(), view);
  for (const Bounds& caster : casters.subspan(1)) seen = united(seen, transformed(caster, view));
  return seen;
}

LightFit fit_directional(const KeyLight& light, const glm::vec3& direction, std::span<const Bounds> casters,
                         int map_size) {
  const glm::mat4 view = look_along(glm::vec3(0.0F), direction);
  const Bounds seen = seen_in(view, casters);
  const glm::vec3 size = seen.high - seen.low;
  // A rim of texels for the filter, and room for the centre to be rounded.
  const float side = rounded_up(std::max(size.x, size.y) * (1.0F + 16.0F / static_cast<float>(map_size)));
  const float texel = side / static_cast<float>(map_size);
  const glm::vec3 middle = 0.5F * (seen.low + seen.high);
  const float x = std::round(middle.x / texel) * texel;
  const float y = std::round(middle.y / texel) * texel;
  const float margin = 0.01F * std::max(size.z, side);
  // The view looks along -z: what is nearest to the light has the greatest z.
  const glm::mat4 clip = glm::orthoRH_ZO(x - side / 2, x + side / 2, y - side / 2, y + side / 2,
                                         -(seen.high.z + margin), -(seen.low.z - margin));
  return {clip * view, texel, 0.5F * light.diameter * (size.z + 2.0F * margin) / side, 0.0F, 0.0F};
}

// Whether some of the box may be within the square that a spot's map sees; tangent: of half its angle.
bool reaches_into(const Bounds& caster, const glm::mat4& view, float tangent) {
  bool before = false, left = false, right = false, low = false, high = false;
  for (const glm::vec3& corner : corners(caster)) {
    const glm::vec4 at = view * glm::vec4(corner, 1.0F);
    const float half = -at.z * tangent;
    before = before || at.z < 0.0F;
    left = left || at.x > -half;
    right = right || at.x < half;
    low = low || at.y > -half;
    high = high || at.y < half;
  }
  return before && left && right && low && high;
}

float cone_of(const KeyLight& light) {
  return std::clamp(light.cone_rad, 0.05F, 2.8F);
}

// m along a spot's axis; farthest is 0 where nothing is in its cone.
struct Depths {
  float nearest = 0.0F, farthest = 0.0F;
};

Depths depths_of(const KeyLight& light, const glm::mat4& view, std::span<const Bounds> casters) {
  Depths depths{std::numeric_limits<float>::infinity(), 0.0F};
  for (const Bounds& caster : casters) {
    if (!reaches_into(caster, view, std::tan(0.5F * cone_of(light)))) continue;
    const Bounds box = transformed(caster, view);
    depths.nearest = std::min(depths.nearest, -box.high.z);
    depths.farthest = std::max(depths.farthest, -box.low.z);
  }
  depths.nearest = std::clamp(depths.nearest, 0.01F * depths.farthest, 0.9F * depths.farthest);
  return depths;
}

LightFit fit_spot(const KeyLight& light, const glm::vec3& direction, std::span<const Bounds> casters,
                  int map_size) {
  constexpr float kMargin = 0.05F;  // so that what moves a little needs no other
  const glm::mat4 view = look_along(light.position, direction);
  const float tangent = std::tan(0.5F * cone_of(light));
  const Depths depths = depths_of(light, view, casters);
  if (depths.farthest <= 0.0F) return {};
  const float nearest = (1.0F - kMargin) * depths.nearest, farthest = (1.0F + kMargin) * depths.farthest;
  const glm::mat4 clip = glm::perspectiveRH_ZO(cone_of(light), 1.0F, nearest, farthest);
  // Seen from a place, what is at depth z hides the light out to a way beside that grows as 1 / z - 1 / its
  // own, measured by the width of the map there; the map's depth changes as 1 / z, too.
  const float per_depth = 1.0F / nearest - 1.0F / farthest;
  const float spread = 0.5F * light.diameter * per_depth / (2.0F * tangent);
  return {clip * view, 2.0F * tangent / static_cast<float>(map_size), spread, nearest, farthest};
}

}  // namespace

LightFit fit_light(const KeyLight& light, std::span<const Bounds> casters, int map_size) {
  const glm::vec3 direction = glm::normalize(light.direction);
  return light.kind == KeyLight::Kind::spot ? fit_spot(light, direction, casters, map_size)
                                            : fit_directional(light, direction, casters, map_size);
}

float width_seen(const KeyLight& light, std::span<const Bounds> casters) {
  const Bounds seen = seen_in(look_along(glm::vec3(0.0F), glm::normalize(light.direction)), casters);
  return std::max(seen.high.x - seen.low.x, seen.high.y - seen.low.y);
}

bool still_fits(const LightFit& fit, const KeyLight& light, std::span<const Bounds> casters, int map_size) {
  constexpr float kWasteful = 0.8F;  // of the texel's width
  if (light.kind == KeyLight::Kind::spot) {
    constexpr float kFar = 0.5F;  // of the farthest: depths between would be told apart too coarsely
    const Depths depths =
        depths_of(light, look_along(light.position, glm::normalize(light.direction)), casters);
    return fit.nearest <= depths.nearest && fit.farthest >= depths.farthest &&
           depths.farthest >= kFar * fit.farthest;
  }
  for (const Bounds& caster : casters) {
    for (const glm::vec3& corner : corners(caster)) {
      const glm::vec4 at = fit.clip_from_world * glm::vec4(corner, 1.0F);
      if (!(at.z >= 0.0F && at.z <= 1.0F && std::abs(at.x) <= 1.0F && std::abs(at.y) <= 1.0F)) return false;
    }
  }
  return fit_light(light, casters, map_size).texel >= kWasteful * fit.texel;
}

}  // namespace fulcrum::render
