#pragma once
// OpenXR with what it has of Vulkan, in the order in which their headers want each other.

#include <vulkan/vulkan.h>

#define XR_USE_GRAPHICS_API_VULKAN
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

namespace fulcrum::xr {

// One of its structures, which say what they are: empty beside that.
template <class Structure>
Structure structure(XrStructureType type) {
  Structure made{};
  made.type = type;
  return made;
}

}  // namespace fulcrum::xr
