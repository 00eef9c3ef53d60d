#pragma once
// Words that every pass is recorded with.

#include <vulkan/vulkan_core.h>

#include "engine/vulkan/commands.h"
#include "engine/vulkan/descriptors.h"

namespace fulcrum::render {

constexpr VkImageAspectFlags kColour = VK_IMAGE_ASPECT_COLOR_BIT;
constexpr VkImageAspectFlags kDepth = VK_IMAGE_ASPECT_DEPTH_BIT;

VkRenderingAttachmentInfo attachment(VkImageView view, VkImageLayout layout, VkAttachmentLoadOp load,
                                     VkAttachmentStoreOp store);

// Begins rendering to all of the targets; null: no such target.
void begin(VkCommandBuffer commands, VkExtent2D extent, const VkRenderingAttachmentInfo* colour,
           const VkRenderingAttachmentInfo* depth);

// Draws from here on into that part of the targets alone; x, y: pixels, of its top left corner.
void set_area(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y, VkExtent2D extent);

void bind(VkCommandBuffer commands, VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set);

// What a pass reads of another one's picture: the nearest texel as it is; beyond an edge, the last before it.
vulkan::SamplerHandle make_texel_sampler(vulkan::Device& device);

// Content is not kept, but what used it last must be over.
vulkan::ImageUse discarded_after(const vulkan::ImageUse& last);

}  // namespace fulcrum::render
