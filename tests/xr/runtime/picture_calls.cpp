#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "tests/xr/runtime/calls.h"
#include "tests/xr/runtime/headset.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

Swapchain& swapchain_of(XrSwapchain handle) {
  return *reinterpret_cast<Swapchain*>(handle);
}

XrResult XRAPI_CALL enumerate_formats(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                      std::int64_t* formats) {
  constexpr std::array<std::int64_t, 2> all{VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_R8G8B8A8_SRGB};
  return give(std::span<const std::int64_t>(all), capacity, count, formats);
}

XrResult XRAPI_CALL create_swapchain(XrSession, const XrSwapchainCreateInfo* info, XrSwapchain* made) {
  log("xrCreateSwapchain " + std::to_string(info->width) + "x" + std::to_string(info->height));
  if (headset->session->breaks) lose();
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  if (info->width > headset->script.largest_width || info->height > headset->script.largest_height)
    return XR_ERROR_VALIDATION_FAILURE;
  auto swapchain = std::make_unique<Swapchain>();
  swapchain->width = info->width;
  swapchain->height = info->height;
  swapchain->format = static_cast<VkFormat>(info->format);
  make_images(*swapchain);
  *made = handle_of<XrSwapchain>(swapchain.get());
  headset->session->swapchains.push_back(std::move(swapchain));
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_swapchain(XrSwapchain handle) {
  log("xrDestroySwapchain");
  destroy_images(swapchain_of(handle));
  std::erase_if(headset->session->swapchains,
                [&](const auto& one) { return handle_of<XrSwapchain>(one.get()) == handle; });
  return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerate_images(XrSwapchain handle, std::uint32_t capacity, std::uint32_t* count,
                                     XrSwapchainImageBaseHeader* images) {
  const Swapchain& swapchain = swapchain_of(handle);
  *count = static_cast<std::uint32_t>(swapchain.images.size());
  if (capacity == 0) return XR_SUCCESS;
  auto* const vulkan = reinterpret_cast<XrSwapchainImageVulkan2KHR*>(images);
  for (std::size_t i = 0; i < swapchain.images.size(); ++i) vulkan[i].image = swapchain.images[i];
  return XR_SUCCESS;
}

XrResult XRAPI_CALL acquire(XrSwapchain handle, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  Swapchain& swapchain = swapchain_of(handle);
  if (swapchain.acquired) {
    wrong("a picture is acquired while another one is drawn");
    return XR_ERROR_CALL_ORDER_INVALID;
  }
  swapchain.acquired = swapchain.next;
  swapchain.next = (swapchain.next + 1) % swapchain.images.size();
  spoil(swapchain, *swapchain.acquired);
  *index = static_cast<std::uint32_t>(*swapchain.acquired);
  log("xrAcquireSwapchainImage");
  return XR_SUCCESS;
}

XrResult XRAPI_CALL wait(XrSwapchain handle, const XrSwapchainImageWaitInfo* info) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  Swapchain& swapchain = swapchain_of(handle);
  if (!swapchain.acquired) {
    wrong("a picture is waited for that was not acquired");
    return XR_ERROR_CALL_ORDER_INVALID;
  }
  if (headset->stalls) {
    if (info->timeout == XR_INFINITE_DURATION) wrong("a picture is waited for that never comes");
    std::this_thread::sleep_for(std::chrono::nanoseconds(info->timeout));
    return XR_TIMEOUT_EXPIRED;
  }
  swapchain.waited = true;
  log("xrWaitSwapchainImage");
  return XR_SUCCESS;
}

XrResult XRAPI_CALL release(XrSwapchain handle, const XrSwapchainImageReleaseInfo*) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  Swapchain& swapchain = swapchain_of(handle);
  if (!swapchain.waited) {
    wrong("a picture is released that was not waited for");
    return XR_ERROR_CALL_ORDER_INVALID;
  }
  swapchain.released = std::exchange(swapchain.acquired, std::nullopt);
  swapchain.waited = false;
  log("xrReleaseSwapchainImage");
  return XR_SUCCESS;
}

}  // namespace

std::span<const Call> picture_calls() {
  static const std::array calls{Call{"xrEnumerateSwapchainFormats", erased(enumerate_formats)},
                                Call{"xrCreateSwapchain", erased(create_swapchain)},
                                Call{"xrDestroySwapchain", erased(destroy_swapchain)},
                                Call{"xrEnumerateSwapchainImages", erased(enumerate_images)},
                                Call{"xrAcquireSwapchainImage", erased(acquire)},
                                Call{"xrWaitSwapchainImage", erased(wait)},
                                Call{"xrReleaseSwapchainImage", erased(release)}};
  return calls;
}

}  // namespace runtime
