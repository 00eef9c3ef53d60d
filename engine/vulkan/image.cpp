#include "engine/vulkan/image.h"

namespace fulcrum::vulkan {

VkImageAspectFlags aspect_of(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

Image::Image(Device& device, const ImageDesc& desc) : extent_(desc.extent) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = desc.format;
  info.extent = {desc.extent.width, desc.extent.height, 1};
  info.mipLevels = 1;
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
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = desc.format;
  view.subresourceRange = {aspect_of(desc.format), 0, 1, 0, 1};
  VkImageView object = VK_NULL_HANDLE;
  check(vkCreateImageView(device.get(), &view, nullptr, &object), "look at an image");
  view_ = ImageViewHandle(device.get(), object);
}

}  // namespace fulcrum::vulkan
