#include "engine/render/stereo_targets.h"

namespace fulcrum::render {
namespace {

vulkan::Image make_finished(vulkan::Device& device, Extent extent) {
  return {device,
          {kPictureFormat,
           {extent.width, extent.height},
           VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT}};
}

vulkan::Binding finished(std::uint32_t number, const vulkan::Image& image, VkSampler sampler) {
  return {number,
          VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
          VK_SHADER_STAGE_FRAGMENT_BIT,
          VK_NULL_HANDLE,
          image.view(),
          sampler};
}

}  // namespace

StereoTargets::StereoTargets(vulkan::Device& device, const RenderPlan& plan, const SharedParts& shared)
    : right(device, plan, shared),
      eyes{make_finished(device, plan.eye), make_finished(device, plan.eye)},
      screen(plan.screen_layer ? make_finished(device, plan.picture) : vulkan::Image()),
      set(device, {finished(0, eyes[0], shared.scene_sampler), finished(1, eyes[1], shared.scene_sampler),
                   finished(2, plan.screen_layer ? screen : eyes[0], shared.scene_sampler)}) {}

}  // namespace fulcrum::render
