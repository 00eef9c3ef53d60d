#include <cstring>

#include "tests/xr/runtime/calls.h"
#include "tests/xr/runtime/headset.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

constexpr XrSystemId kSystem = 1;

XrResult XRAPI_CALL enumerate_extensions(const char*, std::uint32_t capacity, std::uint32_t* count,
                                         XrExtensionProperties* extensions) {
  std::vector<XrExtensionProperties> all(2, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
  std::strcpy(all[0].extensionName, XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME);
  all[0].extensionVersion = XR_KHR_vulkan_enable2_SPEC_VERSION;
  std::strcpy(all[1].extensionName, XR_EXT_HAND_TRACKING_EXTENSION_NAME);
  all[1].extensionVersion = XR_EXT_hand_tracking_SPEC_VERSION;
  if (read_script().tracking == "none") all.pop_back();
  return give(std::span<const XrExtensionProperties>(all), capacity, count, extensions);
}

XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info, XrInstance* instance) {
  log(std::string("xrCreateInstance ") + info->applicationInfo.applicationName);
  if (headset) return XR_ERROR_LIMIT_REACHED;
  headset = std::make_unique<Headset>();
  for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
    log(std::string("with ") + info->enabledExtensionNames[i]);
    if (std::string_view(info->enabledExtensionNames[i]) == XR_EXT_HAND_TRACKING_EXTENSION_NAME)
      headset->tracks_hands = true;
  }
  *instance = handle_of<XrInstance>(headset.get());
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_instance(XrInstance) {
  const Headset& h = *headset;
  log("xrDestroyInstance");
  if (h.session) wrong("an instance goes before its session");
  log("frames " + std::to_string(h.shown) + " left " + std::to_string(h.written[0]) + " right " +
      std::to_string(h.written[1]) + " differing " + std::to_string(h.differing));
  headset.reset();
  return XR_SUCCESS;
}

XrResult XRAPI_CALL instance_properties(XrInstance, XrInstanceProperties* properties) {
  std::strcpy(properties->runtimeName, "the tests' runtime");
  properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL poll_event(XrInstance, XrEventDataBuffer* buffer) {
  if (headset->dead) return XR_ERROR_INSTANCE_LOST;
  if (headset->events.empty()) return XR_EVENT_UNAVAILABLE;
  *buffer = headset->events.front();
  headset->events.pop_front();
  if (buffer->type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED)
    headset->session->told = reinterpret_cast<const XrEventDataSessionStateChanged*>(buffer)->state;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL result_to_string(XrInstance, XrResult value, char buffer[XR_MAX_RESULT_STRING_SIZE]) {
  std::snprintf(buffer, XR_MAX_RESULT_STRING_SIZE, "XrResult %d", value);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL structure_to_string(XrInstance, XrStructureType value,
                                        char buffer[XR_MAX_STRUCTURE_NAME_SIZE]) {
  std::snprintf(buffer, XR_MAX_STRUCTURE_NAME_SIZE, "XrStructureType %d", value);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL get_system(XrInstance, const XrSystemGetInfo* info, XrSystemId* system) {
  if (info->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY) return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
  if (headset->dead) return XR_ERROR_INSTANCE_LOST;
  if (headset->gone > 0) {
    --headset->gone;
    log("xrGetSystem: gone");
    return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
  }
  *system = kSystem;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL system_properties(XrInstance, XrSystemId, XrSystemProperties* properties) {
  properties->systemId = kSystem;
  std::strcpy(properties->systemName, "a headset of paper");
  properties->graphicsProperties = {headset->script.largest_height, headset->script.largest_width,
                                    XR_MIN_COMPOSITION_LAYERS_SUPPORTED};
  properties->trackingProperties = {XR_TRUE, XR_TRUE};
  for (auto* more = static_cast<XrBaseOutStructure*>(properties->next); more != nullptr; more = more->next)
    if (more->type == XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT)
      reinterpret_cast<XrSystemHandTrackingPropertiesEXT*>(more)->supportsHandTracking =
          headset->script.tracking == "yes";
  return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerate_blend_modes(XrInstance, XrSystemId, XrViewConfigurationType,
                                          std::uint32_t capacity, std::uint32_t* count,
                                          XrEnvironmentBlendMode* modes) {
  const std::array all{headset->script.blend};
  return give(std::span<const XrEnvironmentBlendMode>(all), capacity, count, modes);
}

XrResult XRAPI_CALL enumerate_view_configurations(XrInstance, XrSystemId, std::uint32_t capacity,
                                                  std::uint32_t* count, XrViewConfigurationType* types) {
  constexpr std::array all{XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
  return give(std::span<const XrViewConfigurationType>(all), capacity, count, types);
}

XrResult XRAPI_CALL view_configuration_properties(XrInstance, XrSystemId, XrViewConfigurationType type,
                                                  XrViewConfigurationProperties* properties) {
  properties->viewConfigurationType = type;
  properties->fovMutable = XR_FALSE;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerate_views(XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                                    std::uint32_t* count, XrViewConfigurationView* views) {
  auto view = fulcrum::xr::structure<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW);
  view.recommendedImageRectWidth = headset->script.width;
  view.recommendedImageRectHeight = headset->script.height;
  view.maxImageRectWidth = view.maxImageRectHeight = 4096;
  view.recommendedSwapchainSampleCount = view.maxSwapchainSampleCount = 1;
  const std::array all{view, view};
  return give(std::span<const XrViewConfigurationView>(all), capacity, count, views);
}

XrResult XRAPI_CALL string_to_path(XrInstance, const char* text, XrPath* path) {
  std::vector<std::string>& paths = headset->paths;
  for (std::size_t i = 1; i < paths.size(); ++i)
    if (paths[i] == text) {
      *path = i;
      return XR_SUCCESS;
    }
  *path = paths.size();
  paths.emplace_back(text);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL path_to_string(XrInstance, XrPath path, std::uint32_t capacity, std::uint32_t* count,
                                   char* buffer) {
  if (path == XR_NULL_PATH || path >= headset->paths.size()) return XR_ERROR_PATH_INVALID;
  return give_text(headset->paths[path], capacity, count, buffer);
}

XrResult XRAPI_CALL vulkan_requirements(XrInstance, XrSystemId,
                                        XrGraphicsRequirementsVulkan2KHR* requirements) {
  requirements->minApiVersionSupported = XR_MAKE_VERSION(1, 0, 0);
  requirements->maxApiVersionSupported = XR_MAKE_VERSION(1, 3, 0);
  headset->has_vulkan = true;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL create_vulkan_instance(XrInstance, const XrVulkanInstanceCreateInfoKHR* info,
                                           VkInstance* instance, VkResult* result) {
  log("xrCreateVulkanInstanceKHR");
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(
      info->pfnGetInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
  *result = create(info->vulkanCreateInfo, info->vulkanAllocator, instance);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL vulkan_card(XrInstance, const XrVulkanGraphicsDeviceGetInfoKHR* info,
                                VkPhysicalDevice* card) {
  std::uint32_t count = 1;
  const VkResult code = vkEnumeratePhysicalDevices(info->vulkanInstance, &count, card);
  return code == VK_SUCCESS || code == VK_INCOMPLETE ? XR_SUCCESS : XR_ERROR_RUNTIME_FAILURE;
}

XrResult XRAPI_CALL create_vulkan_device(XrInstance, const XrVulkanDeviceCreateInfoKHR* info,
                                         VkDevice* device, VkResult* result) {
  log("xrCreateVulkanDeviceKHR");
  *result = vkCreateDevice(info->vulkanPhysicalDevice, info->vulkanCreateInfo, info->vulkanAllocator, device);
  return XR_SUCCESS;
}

}  // namespace

std::span<const Call> instance_calls() {
  static const std::array calls{
      Call{"xrEnumerateInstanceExtensionProperties", erased(enumerate_extensions)},
      Call{"xrCreateInstance", erased(create_instance)},
      Call{"xrDestroyInstance", erased(destroy_instance)},
      Call{"xrGetInstanceProperties", erased(instance_properties)},
      Call{"xrPollEvent", erased(poll_event)},
      Call{"xrResultToString", erased(result_to_string)},
      Call{"xrStructureTypeToString", erased(structure_to_string)},
      Call{"xrGetSystem", erased(get_system)},
      Call{"xrGetSystemProperties", erased(system_properties)},
      Call{"xrEnumerateEnvironmentBlendModes", erased(enumerate_blend_modes)},
      Call{"xrEnumerateViewConfigurations", erased(enumerate_view_configurations)},
      Call{"xrGetViewConfigurationProperties", erased(view_configuration_properties)},
      Call{"xrEnumerateViewConfigurationViews", erased(enumerate_views)},
      Call{"xrStringToPath", erased(string_to_path)},
      Call{"xrPathToString", erased(path_to_string)},
      Call{"xrGetVulkanGraphicsRequirements2KHR", erased(vulkan_requirements)},
      Call{"xrCreateVulkanInstanceKHR", erased(create_vulkan_instance)},
      Call{"xrGetVulkanGraphicsDevice2KHR", erased(vulkan_card)},
      Call{"xrCreateVulkanDeviceKHR", erased(create_vulkan_device)}};
  return calls;
}

}  // namespace runtime
