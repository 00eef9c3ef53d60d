#pragma once
// A two- or three-dimensional image, its memory and its view.

#include <cstddef>
#include <span>
#include <vector>

#include "engine/vulkan/device.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::vulkan {

struct ImageDesc {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{};  // pixels
  VkImageUsageFlags usage = 0;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  std::uint32_t depth = 0;   // voxels, of a volume; 0: it is flat
  std::uint32_t levels = 1;  // each half as large as the one before, down to one pixel
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

// An image on the device that shaders may sample, with these levels; returns when they have arrived. Texels
// of four or eight bytes. Throws Failure.
Image upload_texture(Device& device, VkFormat format, VkExtent2D extent,
                     std::span<const std::vector<std::uint8_t>> levels);

// The same of a volume, x fastest, then y.
Image upload_volume(Device& device, VkFormat format, VkExtent3D extent,
                    std::span<const std::span<const std::byte>> levels);

VkImageAspectFlags aspect_of(VkFormat format);

}  // namespace fulcrum::vulkan
