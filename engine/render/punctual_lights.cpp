#include "engine/render/punctual_lights.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::render {
namespace {

static_assert(kMostLights == FULCRUM_MOST_LIGHTS);

// X_WL: the frame L that the light's place and direction are in.
gpu::LightData data_of(const PunctualLight& light, const glm::mat4& X_WL) {
  gpu::LightData data{};
  const bool placed = light.kind != PunctualLight::Kind::directional;
  data.position = glm::vec4(glm::vec3(X_WL * glm::vec4(light.position, 1.0F)), placed ? 1.0F : 0.0F);
  data.colour = glm::vec4(light.colour * light.intensity, 0.0F);
  data.fade.y = 1.0F;  // of a point in all directions alike
  if (light.kind != PunctualLight::Kind::point)
    data.direction = glm::vec4(glm::normalize(glm::mat3(X_WL) * light.direction), 0.0F);
  if (light.kind == PunctualLight::Kind::spot) {
    // KHR_lights_punctual, "Inner and Outer Cone Angles".
    const float outer = std::cos(light.outer_cone_rad);
    data.fade.x = 1.0F / std::max(0.001F, std::cos(light.inner_cone_rad) - outer);
    data.fade.y = -outer * data.fade.x;
  }
  if (placed && light.range) data.fade.z = 1.0F / (*light.range * *light.range);
  return data;
}

}  // namespace

PunctualLights::PunctualLights(const VisualDesc& desc) {
  for (const PunctualLight& light : desc.lights) {
    Light& kept = lights_.emplace_back(Light{light, {}});
    if (!light.carried_by) continue;
    const auto first = desc.instances.begin();
    kept.carried_by =
        static_cast<std::size_t>(std::count_if(first, first + static_cast<std::ptrdiff_t>(*light.carried_by),
                                               [](const Instance& instance) { return instance.movable; }));
  }
}

gpu::LightsData PunctualLights::data(std::span<const glm::mat4> X_WM, std::uint32_t layers) const {
  gpu::LightsData data{};
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const Light& light = lights_[i];
    data.each[i] = data_of(light.desc, light.carried_by ? X_WM[*light.carried_by] : glm::mat4(1.0F));
    if ((light.desc.layers & layers) == 0) data.each[i].colour = glm::vec4(0.0F);
  }
  return data;
}

}  // namespace fulcrum::render
