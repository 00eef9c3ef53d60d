#include "engine/vulkan/image.h"

#include <algorithm>
#include <cstring>

#include "engine/vulkan/buffer.h"
#include "engine/vulkan/commands.h"

namespace fulcrum::vulkan {

VkImageAspectFlags aspect_of(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

Image::Image(Device& device, const ImageDesc& desc) : extent_(desc.extent) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = desc.depth > 0 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
  info.format = desc.format;
  info.extent = {desc.extent.width, desc.extent.height, std::max(desc.depth, 1U)};
  info.mipLevels = desc.levels;
  info.arrayLayers = 1;
  info.samples = desc.samples;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = desc.usage;
  VkImage image = VK_NULL_HANDLE;
  check(vkCreateImage(device.get(), &info, nullptr, &image), "make an image");
  image_ = ImageHandle(device.get(), image);

  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device.get(), image, &needs);
  allocation_ = device.memory().allocate(needs, Place::device, true);
  check(vkBindImageMemory(device.get(), image, allocation_.memory(), allocation_.offset()), "place an image");

  VkImageViewCreateInfo view{};
  view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  view.image = image;
  view.viewType = desc.depth > 0 ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
  view.format = desc.format;
  view.subresourceRange = {aspect_of(desc.format), 0, desc.levels, 0, 1};
  VkImageView object = VK_NULL_HANDLE;
  check(vkCreateImageView(device.get(), &view, nullptr, &object), "look at an image");
  view_ = ImageViewHandle(device.get(), object);
}

namespace {

// depth 0: of two dimensions.
Image upload_levels(Device& device, VkFormat format, VkExtent2D extent, std::uint32_t depth,
                    std::span<const std::span<const std::byte>> levels) {
  std::size_t bytes = 0;
  for (const auto& level : levels) bytes += level.size();
  const Buffer staging(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Place::upload);
  Image made(device, {format, extent, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                      VK_SAMPLE_COUNT_1_BIT, depth, static_cast<std::uint32_t>(levels.size())});
  std::vector<VkBufferImageCopy> copies;
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < levels.size(); ++i) {
    std::memcpy(staging.mapped() + at, levels[i].data(), levels[i].size());
    VkBufferImageCopy copy{};
    copy.bufferOffset = at;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, i, 0, 1};
    copy.imageExtent = {std::max(extent.width >> i, 1U), std::max(extent.height >> i, 1U),
                        std::max(depth >> i, 1U)};
    copies.push_back(copy);
    at += levels[i].size();
  }
  Commands(device).run([&](VkCommandBuffer commands) {
    barrier(commands, made.get(), VK_IMAGE_ASPECT_COLOR_BIT, {}, use::kCopyTarget);
    vkCmdCopyBufferToImage(commands, staging.get(), made.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                           static_cast<std::uint32_t>(copies.size()), copies.data());
    barrier(commands, made.get(), VK_IMAGE_ASPECT_COLOR_BIT, use::kCopyTarget, use::kSampled);
  });
  return made;
}

}  // namespace

Image upload_texture(Device& device, VkFormat format, VkExtent2D extent,
                     std::span<const std::vector<std::uint8_t>> levels) {
  std::vector<std::span<const std::byte>> bytes;
  for (const auto& level : levels) bytes.push_back(std::as_bytes(std::span(level)));
  return upload_levels(device, format, extent, 0, bytes);
}

Image upload_volume(Device& device, VkFormat format, VkExtent3D extent,
                    std::span<const std::span<const std::byte>> levels) {
  return upload_levels(device, format, {extent.width, extent.height}, extent.depth, levels);
}

}  // namespace fulcrum::vulkan
