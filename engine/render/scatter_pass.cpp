#include "engine/render/scatter_pass.h"

#include <span>
#include <vector>

#include "engine/render/recording.h"
#include "engine/render/scatter_taps.h"
#include "engine/render/targets.h"

namespace fulcrum::render {

ScatterPass::ScatterPass(vulkan::Device& device, const RenderPlan& plan, VkBuffer frame, VkBuffer distances)
    : sampler_(make_texel_sampler(device)) {
  const std::vector<glm::vec4> taps = scatter_taps(plan.scattering);
  taps_ = vulkan::upload(device, std::as_bytes(std::span(taps)), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const VkExtent2D extent{plan.scene.width, plan.scene.height};
  depth_ = vulkan::Image(device, {kDepthFormat, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT});
  constexpr VkImageUsageFlags drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  entering_ = vulkan::Image(device, {kEnteringFormat, extent, drawn});
  spread_ = vulkan::Image(device, {kSpreadFormat, extent, drawn});
  constexpr VkShaderStageFlags stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  set_ = vulkan::DescriptorSet(device, {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, stage, frame},
                                        {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, stage, VK_NULL_HANDLE,
                                         entering_.view(), sampler_.get()},
                                        {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, stage, distances},
                                        {3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, stage, taps_.get()}});
}

void ScatterPass::record(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
                         const DetailedSurfaces& detailed, VkDescriptorSet scene_set,
                         const Sight& sight) const {
  namespace use = vulkan::use;
  vulkan::barrier(commands, depth_.get(), kDepth, discarded_after(use::kDepthTarget), use::kDepthTarget);
  vulkan::barrier(commands, entering_.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
  // Cleared to what is of no surface.
  const VkRenderingAttachmentInfo colour =
      attachment(entering_.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR,
                 VK_ATTACHMENT_STORE_OP_STORE);
  VkRenderingAttachmentInfo depth = attachment(depth_.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                               VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_DONT_CARE);
  depth.clearValue.depthStencil.depth = 0.0F;  // reversed: infinitely far
  begin(commands, entering_.extent(), &colour, &depth);
  detailed.record_entering(commands, pipelines, geometry, scene_set, sight);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, entering_.get(), kColour, use::kColourTarget, use::kSampled);

  vulkan::barrier(commands, spread_.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
  const VkRenderingAttachmentInfo out =
      attachment(spread_.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, spread_.extent(), &out, nullptr);
  bind(commands, pipelines.scatter.get(), pipelines.scatter_layout.get(), set_.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, spread_.get(), kColour, use::kColourTarget, use::kSampled);
}

}  // namespace fulcrum::render
