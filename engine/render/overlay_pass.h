#pragma once
// What draws over a finished picture: text and gauges, in a room that this one does not know.

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace fulcrum::render {

struct OverlayTarget {
  VkImageView view =
      VK_NULL_HANDLE;            // in layout COLOR_ATTACHMENT_OPTIMAL, before and after; sRGB encoded values
  VkExtent2D extent{};           // pixels
  std::uint64_t generation = 0;  // another number: another view, even where the handle is the same
};

// Format of every picture, and so of the render pass of an overlay. Values are sRGB encoded by the shader
// that writes them, which is what text wants to be blended with.
constexpr VkFormat kPictureFormat = VK_FORMAT_R8G8B8A8_UNORM;

class OverlayPass {
public:
  virtual ~OverlayPass() = default;
  // Called while a frame is recorded, outside any rendering. May throw vulkan::Failure.
  virtual void record(VkCommandBuffer commands, const OverlayTarget& target) = 0;
};

}  // namespace fulcrum::render
