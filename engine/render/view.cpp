#include "engine/render/view.h"

#include <cmath>
#include <cstring>
#include <utility>

#include "engine/render/pipelines.h"

namespace fulcrum::render {
namespace {

std::optional<OcclusionPass> make_occlusion(vulkan::Device& device, const RenderPlan& plan, VkBuffer frame) {
  if (!plan.occlusion) return {};
  return std::optional<OcclusionPass>(std::in_place, device, plan.scene, frame);
}

vulkan::Buffer make_lights(vulkan::Device& device, const RenderPlan& plan) {
  if (plan.lights == 0) return {};
  return {device, sizeof(gpu::LightsData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, vulkan::Place::upload};
}

std::optional<ScatterPass> make_scatter(vulkan::Device& device, const RenderPlan& plan,
                                        const SharedParts& shared, VkBuffer frame) {
  if (plan.scattering == 0) return {};
  return std::optional<ScatterPass>(std::in_place, device, plan, frame, shared.scatter_distances);
}

vulkan::DescriptorSet make_scene_set(vulkan::Device& device, const RenderPlan& plan,
                                     const SharedParts& shared, VkBuffer frame, VkBuffer lights,
                                     const std::optional<OcclusionPass>& occlusion,
                                     const std::optional<ScatterPass>& scatter, std::size_t volume) {
  constexpr VkShaderStageFlags both = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  std::vector<vulkan::Binding> bindings = {{kFrameBinding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, both, frame}};
  if (plan.surfaces) {
    bindings.push_back(
        {kInstancesBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT, shared.instances});
    const auto lit_by = [&](std::uint32_t number, VkImageView view) {
      bindings.push_back({number, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT,
                          VK_NULL_HANDLE, view, shared.environment_sampler});
    };
    lit_by(kEnvironmentBinding, shared.environment);
    lit_by(kOpenBinding, shared.volumes[volume].open.view());
    lit_by(kReceivedBinding, shared.volumes[volume].received.view());
    lit_by(kSentOnBinding, shared.volumes[volume].sent_on.view());
    // Shaders name it even where they do not read it.
    const VolumeOnDevice& of = shared.volumes[volume];
    lit_by(kMirroredBinding, (plan.reflections ? of.mirrored : of.sent_on).view());
    lit_by(kMirroredSidesBinding, (plan.reflections ? of.mirrored_sides : of.sent_on).view());
  }
  if (plan.lights > 0)
    bindings.push_back(
        {kLightsBinding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT, lights});
  if (plan.markers) {
    bindings.push_back(
        {kMarkersBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT, shared.markers});
  }
  if (plan.shadow_size > 0) {
    bindings.push_back({kShadowBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, shared.shadow_map,
                        shared.shadow_sampler});
  }
  if (plan.soft_shadows) {
    bindings.push_back({kShadowDepthBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, shared.shadow_map,
                        shared.shadow_depth_sampler});
  }
  if (occlusion) {
    bindings.push_back({kOcclusionBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, occlusion->view(),
                        occlusion->sampler()});
  }
  if (scatter) {
    bindings.push_back({kScatteredBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, scatter->spread(), scatter->sampler()});
    bindings.push_back({kEnteringBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, scatter->entering(),
                        scatter->sampler()});
  }
  return {device, bindings};
}

vulkan::Binding sampled(const vulkan::Image& image, VkSampler sampler) {
  return {0,
          VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
          VK_SHADER_STAGE_FRAGMENT_BIT,
          VK_NULL_HANDLE,
          image.view(),
          sampler};
}

}  // namespace

View::View(vulkan::Device& device, const RenderPlan& view_plan, const SharedParts& shared)
    : plan(view_plan),
      targets(make_targets(device, plan)),
      frame_buffer(device, sizeof(gpu::FrameData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, vulkan::Place::upload),
      lights(make_lights(device, plan)),
      occlusion(make_occlusion(device, plan, frame_buffer.get())),
      scatter(make_scatter(device, plan, shared, frame_buffer.get())),
      scene_set(
          make_scene_set(device, plan, shared, frame_buffer.get(), lights.get(), occlusion, scatter, volume)),
      tone_set(device, {sampled(targets.scene, shared.scene_sampler)}) {
  if (plan.enlarged()) {
    widen_set = vulkan::DescriptorSet(device, {sampled(targets.finished, shared.scene_sampler)});
    heighten_set = vulkan::DescriptorSet(device, {sampled(targets.widened, shared.scene_sampler)});
  }
  for (const SharedGhost& ghost : shared.ghosts)
    ghosts.push_back(std::make_unique<GhostPass>(device, ghost.look, ghost.edges, plan, targets.depth.view(),
                                                 shared.scene_sampler));
}

void View::light_by(vulkan::Device& device, const SharedParts& shared, std::size_t which) {
  if (which == volume) return;
  volume = which;
  scene_set =
      make_scene_set(device, plan, shared, frame_buffer.get(), lights.get(), occlusion, scatter, volume);
}

void View::update(gpu::FrameData data, const FrameState& state) {
  const float pixel =  // m, its width at a distance of 1 m
      2.0F * std::tan(0.5F * state.camera.vertical_fov_rad) / static_cast<float>(plan.scene.height);
  sight = {data.clip_from_world, state.camera.eye, plan.coarseness * pixel, 0.0F, state.camera.layers};
  data.camera_up.w = sight.per_metre;
  std::memcpy(frame_buffer.mapped(), &data, sizeof(data));
  for (std::size_t i = 0; i < ghosts.size(); ++i)
    ghosts[i]->update(state.ghosts.empty() ? GhostState() : state.ghosts[i], state.camera, plan);
}

void View::light_by(const PunctualLights& models, std::span<const glm::mat4> X_WM) {
  if (plan.lights == 0) return;
  const gpu::LightsData data = models.data(X_WM, sight.layers);
  std::memcpy(lights.mapped(), &data, sizeof(data));
}

RenderPlan inset_plan(const RenderPlan& plan) {
  RenderPlan inset = plan;
  inset.picture = inset.eye = inset.scene = *plan.inset;
  return inset;
}

}  // namespace fulcrum::render
