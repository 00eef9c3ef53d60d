#include "engine/render/recording.h"

namespace fulcrum::render {

// Y up in clip space, as on paper: the viewport is turned over, so that counter-clockwise stays
// counter-clockwise.
void set_area(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y, VkExtent2D extent) {
  const auto width = static_cast<float>(extent.width);
  const auto height = static_cast<float>(extent.height);
  const VkViewport viewport{
      static_cast<float>(x), static_cast<float>(y) + height, width, -height, 0.0F, 1.0F};
  const VkRect2D scissor{{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, extent};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &scissor);
}

VkRenderingAttachmentInfo attachment(VkImageView view, VkImageLayout layout, VkAttachmentLoadOp load,
                                     VkAttachmentStoreOp store) {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = view;
  info.imageLayout = layout;
  info.loadOp = load;
  info.storeOp = store;
  return info;
}

void begin(VkCommandBuffer commands, VkExtent2D extent, const VkRenderingAttachmentInfo* colour,
           const VkRenderingAttachmentInfo* depth) {
  VkRenderingInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  info.renderArea = {{0, 0}, extent};
  info.layerCount = 1;
  info.colorAttachmentCount = colour == nullptr ? 0 : 1;
  info.pColorAttachments = colour;
  info.pDepthAttachment = depth;
  vkCmdBeginRendering(commands, &info);
  set_area(commands, 0, 0, extent);
}

void bind(VkCommandBuffer commands, VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set) {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0, nullptr);
}

vulkan::SamplerHandle make_texel_sampler(vulkan::Device& device) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  return vulkan::make_sampler(device, info);
}

vulkan::ImageUse discarded_after(const vulkan::ImageUse& last) {
  return {last.stage, last.access, VK_IMAGE_LAYOUT_UNDEFINED};
}

}  // namespace fulcrum::render
