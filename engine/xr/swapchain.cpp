#include "engine/xr/swapchain.h"

#include <algorithm>

namespace fulcrum::xr {
namespace {

constexpr std::int64_t kFormat = VK_FORMAT_R8G8B8A8_SRGB;
constexpr XrDuration kPatience = 100'000'000;  // ns: who waits longer can stop no force

bool takes_pictures(XrSession session) {
  std::uint32_t count = 0;
  check(xrEnumerateSwapchainFormats(session, 0, &count, nullptr), "say which pictures it takes");
  std::vector<std::int64_t> formats(count);
  check(xrEnumerateSwapchainFormats(session, count, &count, formats.data()), "say which pictures it takes");
  return std::ranges::find(formats, kFormat) != formats.end();
}

}  // namespace

Swapchain::Swapchain(Session& session, VkExtent2D extent) : session_(session), extent_(extent) {
  if (!takes_pictures(session.get()))
    throw Failure(
        "The headset's runtime takes no 8-bit sRGB pictures (VK_FORMAT_R8G8B8A8_SRGB): update it, or make "
        "another one active.");
  auto info = structure<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT;
  info.format = kFormat;
  info.sampleCount = 1;
  info.width = extent.width;
  info.height = extent.height;
  info.faceCount = 1;
  info.arraySize = 1;
  info.mipCount = 1;
  check(xrCreateSwapchain(session.get(), &info, &swapchain_), "make room for pictures");
  try {
    make_images();
  } catch (const Failure&) {
    xrDestroySwapchain(swapchain_);
    throw;
  }
}

void Swapchain::make_images() {
  std::uint32_t count = 0;
  check(xrEnumerateSwapchainImages(swapchain_, 0, &count, nullptr), "give its pictures");
  images_.assign(count, {XR_TYPE_SWAPCHAIN_IMAGE_VULKAN2_KHR, nullptr, VK_NULL_HANDLE});
  check(xrEnumerateSwapchainImages(swapchain_, count, &count,
                                   reinterpret_cast<XrSwapchainImageBaseHeader*>(images_.data())),
        "give its pictures");
}

Swapchain::~Swapchain() {
  if (swapchain_ != XR_NULL_HANDLE) xrDestroySwapchain(swapchain_);
}

XrSwapchainSubImage Swapchain::part(std::int32_t x, std::int32_t y, VkExtent2D size) const {
  return {swapchain_,
          {{x, y}, {static_cast<std::int32_t>(size.width), static_cast<std::int32_t>(size.height)}},
          0};
}

VkImage Swapchain::acquire() {
  if (!acquired_) {
    const auto acquires = structure<XrSwapchainImageAcquireInfo>(XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO);
    std::uint32_t index = 0;
    if (!session_.goes_on(xrAcquireSwapchainImage(swapchain_, &acquires, &index), "give a picture to draw"))
      return VK_NULL_HANDLE;
    acquired_ = index;
  }
  auto waits = structure<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
  waits.timeout = kPatience;
  const XrResult code = xrWaitSwapchainImage(swapchain_, &waits);
  if (!session_.goes_on(code, "give a picture to draw") || code == XR_TIMEOUT_EXPIRED) return VK_NULL_HANDLE;
  return images_[*acquired_].image;
}

void Swapchain::release() {
  const auto releases = structure<XrSwapchainImageReleaseInfo>(XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO);
  session_.goes_on(xrReleaseSwapchainImage(swapchain_, &releases), "take a picture");
  acquired_.reset();
  released_ = true;
}

void copy_to(VkCommandBuffer commands, VkImage picture, VkImage target, VkExtent2D extent) {
  namespace use = vulkan::use;
  constexpr VkImageAspectFlags kColour = VK_IMAGE_ASPECT_COLOR_BIT;
  // All of it is written over: what it held is not needed. The runtime waits for what is drawn on the queue.
  const vulkan::ImageUse before{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE,
                                VK_IMAGE_LAYOUT_UNDEFINED};
  vulkan::barrier(commands, target, kColour, before, use::kCopyTarget);
  VkImageCopy all{};
  all.srcSubresource = all.dstSubresource = {kColour, 0, 0, 1};
  all.extent = {extent.width, extent.height, 1};
  vkCmdCopyImage(commands, picture, use::kCopySource.layout, target, use::kCopyTarget.layout, 1, &all);
  vulkan::barrier(commands, target, kColour, use::kCopyTarget, use::kColourTarget);
}

}  // namespace fulcrum::xr
