#include "engine/render/targets.h"

namespace fulcrum::render {

Targets make_targets(vulkan::Device& device, const RenderPlan& plan) {
  const VkExtent2D scene{plan.scene.width, plan.scene.height};
  const VkSampleCountFlagBits samples = sample_count(plan);
  Targets made;
  if (samples != VK_SAMPLE_COUNT_1_BIT)
    made.samples = vulkan::Image(device, {kSceneFormat, scene, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, samples});
  made.scene = vulkan::Image(
      device, {kSceneFormat, scene, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  const VkImageUsageFlags read_by_ghost = plan.ghosts ? VK_IMAGE_USAGE_SAMPLED_BIT : 0;
  made.depth = vulkan::Image(
      device, {kDepthFormat, scene, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | read_by_ghost, samples});
  if (plan.enlarged()) {
    constexpr VkImageUsageFlags use = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    made.finished = vulkan::Image(device, {kPictureFormat, scene, use});
    made.widened = vulkan::Image(device, {kPictureFormat, {plan.eye.width, scene.height}, use});
  }
  return made;
}

vulkan::Image make_picture(vulkan::Device& device, const RenderPlan& plan) {
  return {device,
          {kPictureFormat,
           {plan.picture.width, plan.picture.height},
           VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

vulkan::Image make_shadow_map(vulkan::Device& device, const RenderPlan& plan) {
  const auto side = static_cast<std::uint32_t>(plan.shadow_size);
  return {device,
          {kDepthFormat,
           {side, side},
           VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
               VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}};
}

}  // namespace fulcrum::render
