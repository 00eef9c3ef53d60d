#pragma once
// The pictures of a window. A frame is drawn elsewhere and copied into one of them.

#include <functional>
#include <optional>
#include <vector>

#include "engine/vulkan/commands.h"

namespace fulcrum::vulkan {

// What a window offers to draw on; destroyed before its instance and its window.
class Surface {
public:
  Surface(VkInstance instance, VkSurfaceKHR surface) : instance_(instance), surface_(surface) {}
  Surface(Surface&& other) noexcept;
  Surface& operator=(Surface&& other) noexcept;
  ~Surface();
  VkSurfaceKHR get() const { return surface_; }

private:
  VkInstance instance_ = VK_NULL_HANDLE;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
};

enum class Pace {
  screen,  // in step with it: showing waits for it
  free     // showing waits for nothing where the driver has a way to, since something else sets the pace
};

class Swapchain {
public:
  // Fails with a sentence where the window offers no 8-bit colour
  // format. Nothing is made yet: a window may still be without size.
  static Result<std::unique_ptr<Swapchain>> create(Device& device, VkSurfaceKHR surface,
                                                   Pace pace = Pace::screen);

  // Waits until one of the window's pictures is free, for the screen may hold all of them: what is sampled
  // after that is seen the soonest. wanted, and false: as show(), which waits as well where nobody has.
  // Throws Failure.
  bool wait(VkExtent2D wanted);

  // Shows `source`, an image in layout TRANSFER_SRC once `record` has run, scaled to the window if it must
  // be. `wanted`: the window's size in pixels; where it is zero (minimised) nothing is drawn and the answer
  // is false. Made anew whenever the window has changed. before_submission: as of Commands. Throws Failure.
  bool show(Commands& commands, VkExtent2D wanted, VkImage source, VkExtent2D source_extent,
            const std::function<void(VkCommandBuffer)>& record,
            const std::function<void()>& before_submission = {});

private:
  Swapchain(Device& device, VkSurfaceKHR surface, VkSurfaceFormatKHR format, VkPresentModeKHR mode)
      : device_(device), surface_(surface), format_(format), mode_(mode) {}

  bool remake(VkExtent2D wanted);
  std::optional<std::uint32_t> acquire();

  Device& device_;
  VkSurfaceKHR surface_;
  VkSurfaceFormatKHR format_;
  VkPresentModeKHR mode_;
  VkExtent2D extent_{};
  VkExtent2D asked_{};  // the window size it was made for
  bool stale_ = true;
  std::optional<std::uint32_t> free_;  // the picture that was waited for
  SwapchainHandle swapchain_;
  std::vector<VkImage> images_;
  std::vector<SemaphoreHandle>
      drawn_;  // one an image: the screen may still wait on it when the next frame starts
  SemaphoreHandle acquired_;
};

}  // namespace fulcrum::vulkan
