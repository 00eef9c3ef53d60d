#include "engine/render/occlusion_pass.h"

#include "engine/render/recording.h"
#include "engine/render/targets.h"

namespace fulcrum::render {

Extent occlusion_extent(Extent scene) {
  return {(scene.width + 1) / 2, (scene.height + 1) / 2};
}

OcclusionPass::OcclusionPass(vulkan::Device& device, Extent scene, VkBuffer frame)
    : sampler_(make_texel_sampler(device)) {
  const Extent half = occlusion_extent(scene);
  const VkExtent2D extent{half.width, half.height};
  depth_ = vulkan::Image(device, {kDepthFormat, extent,
                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  const vulkan::ImageDesc found{kOcclusionFormat, extent,
                                VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
  rough_ = vulkan::Image(device, found);
  smooth_ = vulkan::Image(device, found);
  const auto sampled = [&](std::uint32_t number, VkImageView view) {
    return vulkan::Binding{number,
                           VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                           VK_SHADER_STAGE_FRAGMENT_BIT,
                           VK_NULL_HANDLE,
                           view,
                           sampler_.get()};
  };
  set_ = vulkan::DescriptorSet(device,
                               {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT, frame},
                                sampled(1, depth_.view()),
                                sampled(2, rough_.view())});
}

void OcclusionPass::record(VkCommandBuffer commands, const Pipelines& pipelines,
                           const SceneGeometry& geometry, const DetailedSurfaces* detailed,
                           VkDescriptorSet scene_set, const Sight& sight) const {
  record_depth(commands, pipelines, geometry, detailed, scene_set, sight);
  record_fullscreen(commands, pipelines, pipelines.occlusion.get(), rough_);
  record_fullscreen(commands, pipelines, pipelines.occlusion_smooth.get(), smooth_);
}

void OcclusionPass::record_depth(VkCommandBuffer commands, const Pipelines& pipelines,
                                 const SceneGeometry& geometry, const DetailedSurfaces* detailed,
                                 VkDescriptorSet scene_set, const Sight& sight) const {
  namespace use = vulkan::use;
  vulkan::barrier(commands, depth_.get(), kDepth, discarded_after(use::kSampled), use::kDepthTarget);
  VkRenderingAttachmentInfo depth = attachment(depth_.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                               VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_STORE);
  depth.clearValue.depthStencil.depth = 0.0F;  // reversed: infinitely far
  begin(commands, depth_.extent(), nullptr, &depth);
  bind(commands, pipelines.occluders.get(), pipelines.scene_layout.get(), scene_set);
  vkCmdSetCullMode(commands, VK_CULL_MODE_BACK_BIT);
  Sight coarse = sight;
  coarse.per_metre *= 2.0F;  // pixels here are twice as wide
  geometry.draw_plain(commands, coarse);
  if (detailed != nullptr) detailed->record_occluders(commands, pipelines, geometry, scene_set, coarse);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, depth_.get(), kDepth, use::kDepthTarget, use::kSampled);
}

void OcclusionPass::record_fullscreen(VkCommandBuffer commands, const Pipelines& pipelines,
                                      VkPipeline pipeline, const vulkan::Image& to) const {
  namespace use = vulkan::use;
  vulkan::barrier(commands, to.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
  const VkRenderingAttachmentInfo colour =
      attachment(to.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, to.extent(), &colour, nullptr);
  bind(commands, pipeline, pipelines.occlusion_layout.get(), set_.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, to.get(), kColour, use::kColourTarget, use::kSampled);
}

}  // namespace fulcrum::render
