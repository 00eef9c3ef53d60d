#pragma once
// How building fails: with a sentence that names the remedy.
//
// Two tiers below it. A Vulkan call that fails (memory, a lost device) throws Failure from inside the
// wrappers; the entry points that other rooms call catch it and return a Result, so that no exception leaves
// engine/vulkan or engine/render.

#include <vulkan/vulkan_core.h>

#include <stdexcept>
#include <string>

#include "haptics/math/result.h"

namespace fulcrum::vulkan {

using fulcrum::Error;
using fulcrum::Result;

// A Vulkan call that failed at run time.
class Failure : public std::runtime_error {
public:
  explicit Failure(const std::string& sentence, VkResult code = VK_ERROR_UNKNOWN)
      : std::runtime_error(sentence), code_(code) {}
  // There was not enough memory, of the graphics card or of the machine.
  bool is_of_memory() const {
    return code_ == VK_ERROR_OUT_OF_DEVICE_MEMORY || code_ == VK_ERROR_OUT_OF_HOST_MEMORY;
  }

private:
  VkResult code_;
};

// "VK_ERROR_DEVICE_LOST" and so on; the number for a code that is not expected here.
std::string name_of(VkResult code);

// Throws Failure "Vulkan could not DOING: CODE." with a remedy unless the code is VK_SUCCESS.
void check(VkResult code, const char* doing);

}  // namespace fulcrum::vulkan
