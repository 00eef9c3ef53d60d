#include "engine/vulkan/swapchain.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace fulcrum::vulkan {
namespace {

SemaphoreHandle make_semaphore(VkDevice device) {
  VkSemaphoreCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  VkSemaphore semaphore = VK_NULL_HANDLE;
  check(vkCreateSemaphore(device, &info, nullptr, &semaphore), "make a semaphore");
  return {device, semaphore};
}

VkPresentModeKHR mode_for(Pace pace, const Device& device, VkSurfaceKHR surface) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, nullptr);
  std::vector<VkPresentModeKHR> offered(count);
  vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, offered.data());
  for (const auto mode : {VK_PRESENT_MODE_MAILBOX_KHR, VK_PRESENT_MODE_IMMEDIATE_KHR})
    if (pace == Pace::free && std::find(offered.begin(), offered.end(), mode) != offered.end()) return mode;
  return VK_PRESENT_MODE_FIFO_KHR;  // every driver has it
}

VkCompositeAlphaFlagBitsKHR alpha_mode(VkCompositeAlphaFlagsKHR offered) {
  for (const auto mode : {VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR, VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR})
    if ((offered & mode) != 0) return mode;
  return VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR;  // the same picture: its alpha is 1 everywhere
}

void copy_picture(VkCommandBuffer commands, VkImage source, VkExtent2D from, VkImage target, VkExtent2D to) {
  const auto corner = [](VkExtent2D extent) {
    return VkOffset3D{static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height), 1};
  };
  VkImageBlit blit{};
  blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  blit.srcOffsets[1] = corner(from);
  blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  blit.dstOffsets[1] = corner(to);
  const bool same = from.width == to.width && from.height == to.height;
  vkCmdBlitImage(commands, source, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, same ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
}

}  // namespace

Surface::Surface(Surface&& other) noexcept
    : instance_(other.instance_), surface_(std::exchange(other.surface_, VkSurfaceKHR{VK_NULL_HANDLE})) {}

Surface& Surface::operator=(Surface&& other) noexcept {
  std::swap(instance_, other.instance_);
  std::swap(surface_, other.surface_);
  return *this;
}

Surface::~Surface() {
  if (surface_ != VK_NULL_HANDLE) vkDestroySurfaceKHR(instance_, surface_, nullptr);
}

Result<std::unique_ptr<Swapchain>> Swapchain::create(Device& device, VkSurfaceKHR surface, Pace pace) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, nullptr);
  std::vector<VkSurfaceFormatKHR> offered(count);
  vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, offered.data());
  // The picture is sRGB encoded already: a format that encodes once more would be wrong.
  const auto fits = std::find_if(offered.begin(), offered.end(), [](const VkSurfaceFormatKHR& format) {
    return (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) &&
           format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
  });
  if (fits == offered.end()) {
    return Error{
        device.info().name +
        " offers no 8-bit sRGB pictures for this window: choose another device with --gpu, or run without a "
        "window."};
  }
  return std::unique_ptr<Swapchain>(new Swapchain(device, surface, *fits, mode_for(pace, device, surface)));
}

bool Swapchain::remake(VkExtent2D wanted) {
  VkSurfaceCapabilitiesKHR can{};
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &can),
        "ask a window for its size");
  VkExtent2D extent = can.currentExtent;
  if (extent.width ==
      std::numeric_limits<std::uint32_t>::max()) {  // the window takes the size of its pictures
    extent.width = std::clamp(wanted.width, can.minImageExtent.width, can.maxImageExtent.width);
    extent.height = std::clamp(wanted.height, can.minImageExtent.height, can.maxImageExtent.height);
  }
  if (extent.width == 0 || extent.height == 0) return false;
  check(vkDeviceWaitIdle(device_.get()), "wait for the screen");

  VkSwapchainCreateInfoKHR info{};
  info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
  info.surface = surface_;
  info.minImageCount =
      can.maxImageCount == 0 ? can.minImageCount + 1 : std::min(can.minImageCount + 1, can.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = alpha_mode(can.supportedCompositeAlpha);
  info.presentMode = mode_;
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_.get();
  VkSwapchainKHR made = VK_NULL_HANDLE;
  check(vkCreateSwapchainKHR(device_.get(), &info, nullptr, &made), "show pictures in the window");
  swapchain_ = SwapchainHandle(device_.get(), made);
  std::uint32_t count = 0;
  check(vkGetSwapchainImagesKHR(device_.get(), made, &count, nullptr), "find the window's pictures");
  images_.resize(count);
  check(vkGetSwapchainImagesKHR(device_.get(), made, &count, images_.data()), "find the window's pictures");
  drawn_.clear();
  for (std::uint32_t i = 0; i < count; ++i) drawn_.push_back(make_semaphore(device_.get()));
  acquired_ = make_semaphore(device_.get());
  extent_ = extent;
  asked_ = wanted;
  stale_ = false;
  return true;
}

std::optional<std::uint32_t> Swapchain::acquire() {
  std::uint32_t index = 0;
  const VkResult code =
      vkAcquireNextImageKHR(device_.get(), swapchain_.get(), std::numeric_limits<std::uint64_t>::max(),
                            acquired_.get(), VK_NULL_HANDLE, &index);
  if (code == VK_ERROR_OUT_OF_DATE_KHR) {
    stale_ = true;
    return std::nullopt;
  }
  if (code == VK_SUBOPTIMAL_KHR) {
    stale_ = true;  // after this frame
    return index;
  }
  check(code, "take a picture of the window");
  return index;
}

bool Swapchain::wait(VkExtent2D wanted) {
  if (wanted.width == 0 || wanted.height == 0) return false;
  if (wanted.width != asked_.width || wanted.height != asked_.height) stale_ = true;
  if (free_) return true;  // also where the window has changed since: the next picture is of the new size
  if (stale_ && !remake(wanted)) return false;
  free_ = acquire();
  return free_.has_value();
}

bool Swapchain::show(Commands& commands, VkExtent2D wanted, VkImage source, VkExtent2D source_extent,
                     const std::function<void(VkCommandBuffer)>& record,
                     const std::function<void()>& before_submission) {
  if (!wait(wanted)) return false;
  const std::optional<std::uint32_t> index = std::exchange(free_, std::nullopt);
  const VkImage target = images_[*index];
  const VkSemaphore drawn = drawn_[*index].get();
  const auto record_and_copy = [&](VkCommandBuffer buffer) {
    record(buffer);
    // From the stage that waits for acquisition, so that the change of layout waits, too.
    const ImageUse acquired{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE,
                            VK_IMAGE_LAYOUT_UNDEFINED};
    barrier(buffer, target, VK_IMAGE_ASPECT_COLOR_BIT, acquired, use::kCopyTarget);
    copy_picture(buffer, source, source_extent, target, extent_);
    barrier(buffer, target, VK_IMAGE_ASPECT_COLOR_BIT, use::kCopyTarget, use::kPresented);
  };
  commands.run(record_and_copy, {acquired_.get(), VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, drawn},
               before_submission);

  const VkSwapchainKHR swapchain = swapchain_.get();
  VkPresentInfoKHR present{};
  present.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
  present.waitSemaphoreCount = 1;
  present.pWaitSemaphores = &drawn;
  present.swapchainCount = 1;
  present.pSwapchains = &swapchain;
  present.pImageIndices = &*index;
  const VkResult code = vkQueuePresentKHR(device_.queue(), &present);
  if (code == VK_ERROR_OUT_OF_DATE_KHR || code == VK_SUBOPTIMAL_KHR)
    stale_ = true;
  else
    check(code, "show a picture in the window");
  return true;
}

}  // namespace fulcrum::vulkan
