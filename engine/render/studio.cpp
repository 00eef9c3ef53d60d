#include "engine/render/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum::render {
namespace {

// A rectangular light infinitely far away: direction to its middle, half width and half height as tangents.
struct SoftBox {
  glm::vec3 towards;
  glm::vec3 across;
  glm::vec2 half_size;
  glm::vec3 radiance;  // where the sky's brightest colour is 1
};

constexpr float kEdge = 0.08F;  // how softly a box ends, as a tangent; and the horizon

const std::array<SoftBox, 4>& boxes() {
  static const std::array<SoftBox, 4> all = {{
      // two tubes above
      {{0.3162F, 0.9487F, 0.0F}, {0.0F, 0.0F, 1.0F}, {1.1F, 0.17F}, {7.0F, 6.8F, 6.4F}},
      {{-0.2425F, 0.9701F, 0.0F}, {0.0F, 0.0F, 1.0F}, {1.1F, 0.17F}, {7.0F, 6.8F, 6.4F}},
      // a tall strip at the left
      {{-0.8729F, 0.2182F, 0.4364F}, {0.4472F, 0.0F, 0.8944F}, {0.22F, 0.95F}, {3.6F, 3.6F, 3.6F}},
      // a cool strip behind at the right
      {{0.7715F, 0.3086F, -0.5563F}, {0.5849F, 0.0F, 0.8111F}, {0.30F, 0.80F}, {2.3F, 2.7F, 3.2F}},
  }};
  return all;
}

float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

float covered(const SoftBox& box, const glm::vec3& d) {
  const float facing = glm::dot(d, box.towards);
  if (facing <= 0.05F) return 0.0F;
  const glm::vec3 upwards = glm::cross(box.towards, box.across);
  const glm::vec2 at = glm::vec2(glm::dot(d, box.across), glm::dot(d, upwards)) / facing;
  const auto inside = [&](float half_size, float where) {
    return 1.0F - smoothstep(half_size - kEdge, half_size + kEdge, std::abs(where));
  };
  return inside(box.half_size.x, at.x) * inside(box.half_size.y, at.y) * smoothstep(0.05F, 0.35F, facing);
}

}  // namespace

glm::vec3 studio_radiance(const Ambient& ambient, const glm::vec3& from) {
  const glm::vec3 d(ambient.mirrored ? -from.x : from.x, from.y, from.z);
  const glm::vec3 sky = ambient.sky * ambient.intensity, ground = ambient.ground * ambient.intensity;
  // Walls fall off towards the horizon: this is the dark line that makes a chromed tube read as round.
  const glm::vec3 above = sky * glm::mix(0.35F, 1.0F, smoothstep(0.0F, 0.7F, d.y));
  const glm::vec3 below = ground * glm::mix(0.45F, 1.0F, smoothstep(0.0F, 0.8F, -d.y));
  glm::vec3 radiance = glm::mix(below, above, smoothstep(-kEdge, kEdge, d.y));
  const float brightness = std::max({sky.r, sky.g, sky.b});
  for (const SoftBox& box : boxes()) radiance += box.radiance * (brightness * covered(box, d));
  return radiance;
}

std::vector<glm::vec3> studio_panorama(const Ambient& ambient, std::uint32_t width, std::uint32_t height) {
  constexpr float kPi = std::numbers::pi_v<float>;
  std::vector<glm::vec3> pixels;
  pixels.reserve(std::size_t{width} * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    const float polar = kPi * (static_cast<float>(row) + 0.5F) / static_cast<float>(height);
    for (std::uint32_t column = 0; column < width; ++column) {
      const float azimuth = 2.0F * kPi * (static_cast<float>(column) + 0.5F) / static_cast<float>(width);
      const glm::vec3 direction(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                -std::sin(polar) * std::cos(azimuth));
      pixels.push_back(studio_radiance(ambient, direction));
    }
  }
  return pixels;
}

}  // namespace fulcrum::render
