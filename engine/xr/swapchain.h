#pragma once
// Pictures that a headset's runtime shows. What is in them is drawn elsewhere and copied here.

#include <optional>
#include <vector>

#include "engine/vulkan/commands.h"
#include "engine/xr/session.h"

namespace fulcrum::xr {

class Swapchain {
public:
  // extent: pixels. The session outlives it. Throws Failure, such as where the runtime takes no such
  // pictures.
  Swapchain(Session& session, VkExtent2D extent);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  VkExtent2D extent() const { return extent_; }
  // Of it, in a layer: pixels, from the picture's top left corner.
  XrSwapchainSubImage part(std::int32_t x, std::int32_t y, VkExtent2D size) const;

  // A picture to copy to, which the runtime shows from release() on. Null: the session has been lost, or the
  // runtime has not given one for a tenth of a second; it may yet.
  VkImage acquire();
  void release();
  bool was_released() const { return released_; }  // a picture of it: only then can a layer show it

private:
  void make_images();

  Session& session_;
  VkExtent2D extent_;
  XrSwapchain swapchain_ = XR_NULL_HANDLE;
  std::vector<XrSwapchainImageVulkan2KHR> images_;
  std::optional<std::uint32_t> acquired_;
  bool released_ = false;
};

// Records a copy of a picture, which is in layout TRANSFER_SRC and of the same size, into one that acquire()
// gave. Its bytes are sRGB encoded, and stay what they are.
void copy_to(VkCommandBuffer commands, VkImage picture, VkImage target, VkExtent2D extent);

}  // namespace fulcrum::xr
