#pragma once
// A two-dimensional image with one level, its memory and its view.

#include "engine/vulkan/device.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::vulkan {

struct ImageDesc {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{};  // pixels
  VkImageUsageFlags usage = 0;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
};

class Image {
public:
  Image() = default;
  // Throws Failure where memory runs out.
  Image(Device& device, const ImageDesc& desc);

  VkImage get() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  VkExtent2D extent() const { return extent_; }
  explicit operator bool() const { return static_cast<bool>(image_); }

private:
  Allocation allocation_;
  ImageHandle image_;  // after the allocation: destroyed before the memory is given back
  ImageViewHandle view_;
  VkExtent2D extent_{};
};

VkImageAspectFlags aspect_of(VkFormat format);

}  // namespace fulcrum::vulkan
