#include "engine/vulkan/result.h"

namespace fulcrum::vulkan {

std::string name_of(VkResult code) {
  switch (code) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
      return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_SURFACE_LOST_KHR:
      return "VK_ERROR_SURFACE_LOST_KHR";
    case VK_ERROR_OUT_OF_DATE_KHR:
      return "VK_ERROR_OUT_OF_DATE_KHR";
    default:
      return "VkResult " + std::to_string(static_cast<int>(code));
  }
}

void check(VkResult code, const char* doing) {
  if (code == VK_SUCCESS) return;
  std::string sentence = std::string("Vulkan could not ") + doing + " (" + name_of(code) + ")";
  switch (code) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      sentence += "; use a smaller picture, fewer samples or a smaller shadow map.";
      break;
    case VK_ERROR_DEVICE_LOST:
      sentence +=
          "; the graphics driver has reset: start the program again, or choose another device with --gpu.";
      break;
    default:
      sentence += "; update the graphics driver, or choose another device with --gpu.";
  }
  throw Failure(sentence, code);
}

}  // namespace fulcrum::vulkan
