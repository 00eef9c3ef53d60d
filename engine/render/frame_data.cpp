#include "engine/render/frame_data.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "engine/render/occlusion_pass.h"

namespace fulcrum::render {
namespace {

glm::vec4 with(const glm::vec3& xyz, float w = 0.0F) {
  return {xyz, w};
}

void write_light(gpu::FrameData& data, const KeyLight& light) {
  const bool spot = light.kind == KeyLight::Kind::spot;
  const float half = 0.5F * light.cone_rad;
  const float at_one_metre = 1.0F + 0.25F * light.diameter * light.diameter;
  const glm::vec3 direction = glm::normalize(light.direction);
  data.key_position = spot ? with(light.position, 1.0F) : with(-direction);
  data.key_direction = with(direction, spot ? std::cos(half) : -3.0F);
  data.key_colour =
      with(light.colour * (light.intensity * at_one_metre), spot ? std::cos(0.8F * half) : -2.0F);
}

float aspect_of(const Camera& camera, Extent picture) {
  return camera.aspect.value_or(static_cast<float>(picture.width) / static_cast<float>(picture.height));
}

}  // namespace

glm::mat4 view_of(const Camera& camera) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
  const bool along = std::abs(glm::dot(forward, camera.up)) > 0.9999F;
  const glm::vec3 up = along ? glm::vec3(0.0F, 0.0F, -1.0F) : camera.up;
  return glm::lookAt(camera.eye, camera.target, up);
}

float nearest_seen(const Camera& camera) {
  return std::min(0.005F, 0.05F * glm::length(camera.target - camera.eye));
}

glm::mat4 clip_from_world(const Camera& camera, Extent picture) {
  // Depth near/z: a float keeps it equally exact at 5 mm and at 50 m, and nothing is ever too far.
  const float f = 1.0F / std::tan(0.5F * camera.vertical_fov_rad);
  const float aspect = aspect_of(camera, picture);
  glm::mat4 projection(0.0F);
  projection[0][0] = f / aspect;
  projection[1][1] = f;
  projection[2][0] = f / aspect * camera.lean.x;  // what lies that way ends in the middle
  projection[2][1] = f * camera.lean.y;
  projection[2][3] = -1.0F;
  projection[3][2] = nearest_seen(camera);
  return projection * view_of(camera);
}

gpu::FrameData frame_data(const Setting& setting, const FrameState& state, Extent picture, Extent scene,
                          const LightFit& light, int shadow_size) {
  const glm::mat4 world_from_view = glm::transpose(view_of(state.camera));  // its rotation
  gpu::FrameData data{};
  data.clip_from_world = clip_from_world(state.camera, picture);
  data.shadow_from_world = light.clip_from_world;
  // A float holds a second exactly enough for an hour, not for a day.
  data.eye = with(state.camera.eye, static_cast<float>(std::fmod(state.time_s, 3600.0)));
  data.camera_right = with(glm::vec3(world_from_view[0]));
  data.camera_up = with(glm::vec3(world_from_view[1]));
  write_light(data, setting.key_light.value_or(KeyLight{.intensity = 0.0F}));
  std::ranges::copy(setting.around.linear, data.around_linear);
  std::ranges::copy(setting.around.quadratic, data.around_quadratic);
  data.around_rest = with(setting.around.rest);
  data.background_top = with(setting.background.top);
  data.background_bottom = with(setting.background.bottom);
  const float tangent = std::tan(0.5F * state.camera.vertical_fov_rad);
  data.lens = {tangent * aspect_of(state.camera, picture), tangent, state.camera.lean.x, state.camera.lean.y};
  const Extent hidden = occlusion_extent(scene);
  data.occlusion = {static_cast<float>(hidden.width), static_cast<float>(hidden.height),
                    nearest_seen(state.camera), 0.0F};
  data.shadow = {shadow_size > 0 ? 1.0F / static_cast<float>(shadow_size) : 0.0F, light.texel, light.spread,
                 setting.key_light ? 0.5F * setting.key_light->diameter : 0.0F};
  return data;
}

void write_volume(const VolumeOnDevice& volume, gpu::FrameData& to) {
  to.volume_from_world = volume.from_world;
  to.volume_low = volume.low;
  to.unhidden = volume.unhidden;
  to.mirror_from_world = volume.mirror_from_world;
  to.mirror_low = volume.mirror_low;
}

std::uint32_t write_markers(std::span<const Marker> markers, std::span<const MarkerState> states,
                            const MarkerColours& colours, gpu::MarkerData* to) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto [kind, tint] = [&]() -> std::pair<float, glm::vec3> {
      switch (states[i].show) {
        case MarkerState::Show::dwelling:
          return {FULCRUM_MARKER_DWELLING, colours.dwelling};
        case MarkerState::Show::done:
          return {FULCRUM_MARKER_DONE, colours.done};
        case MarkerState::Show::avoid:
          return {FULCRUM_MARKER_DONE, colours.avoid};
        default:
          return {FULCRUM_MARKER_NEXT, colours.next};
      }
    }();
    if (states[i].show != MarkerState::Show::hidden) {
      to[count].sphere = with(states[i].position.value_or(markers[i].position), markers[i].radius);
      to[count].state = {kind, std::clamp(states[i].progress, 0.0F, 1.0F), 0.0F, 0.0F};
      to[count].tint = with(tint);
      ++count;
    }
  }
  return count;
}

}  // namespace fulcrum::render
