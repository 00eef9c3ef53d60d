#include "engine/xr/instance.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

namespace fulcrum::xr {
namespace {

constexpr const char* kTakeControllers = "or take its controllers (--device controller).";

bool offers(const std::vector<XrExtensionProperties>& extensions, std::string_view name) {
  return std::ranges::any_of(
      extensions, [name](const XrExtensionProperties& extension) { return name == extension.extensionName; });
}

// As much smaller in both directions as it has to be to lie within a picture of that size beside its like;
// largest: 0: any.
VkExtent2D within(VkExtent2D eye, VkExtent2D largest) {
  double part = 1;
  if (largest.width > 0) part = std::min(part, 0.5 * largest.width / eye.width);
  if (largest.height > 0) part = std::min(part, static_cast<double>(largest.height) / eye.height);
  return {std::max(static_cast<std::uint32_t>(part * eye.width), 1U),
          std::max(static_cast<std::uint32_t>(part * eye.height), 1U)};
}

// Of the active runtime; empty, too, where there is none.
std::vector<XrExtensionProperties> runtime_extensions() {
  std::uint32_t count = 0;
  if (XR_FAILED(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr))) return {};
  std::vector<XrExtensionProperties> extensions(count, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
  if (XR_FAILED(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, extensions.data()))) return {};
  return extensions;
}

Error explain(XrResult code) {
  switch (code) {
    case XR_ERROR_RUNTIME_UNAVAILABLE:
    case XR_ERROR_FILE_ACCESS_ERROR:
    case XR_ERROR_FILE_CONTENTS_INVALID:
      return {
          "--xr needs the OpenXR runtime of a headset, and none is active here: start the headset's own, "
          "such "
          "as SteamVR or Monado, and make it the active one there, or name its manifest in XR_RUNTIME_JSON."};
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
    case XR_ERROR_FORM_FACTOR_UNSUPPORTED:
      return {"The OpenXR runtime runs, and has no headset: plug it in, or wake it, and start this again."};
    default:
      return {"The headset's OpenXR runtime did not start (" + name_of(code) + "): start it anew."};
  }
}

std::string version_text(XrVersion version) {
  return std::to_string(XR_VERSION_MAJOR(version)) + "." + std::to_string(XR_VERSION_MINOR(version)) + "." +
         std::to_string(XR_VERSION_PATCH(version));
}

}  // namespace

Result<std::unique_ptr<Instance>> Instance::create(bool hands) {
  // What is wrong is said in our own sentence; who wants the loader's words sets it.
  setenv("XR_LOADER_DEBUG", "none", 0);  // NOLINT(concurrency-mt-unsafe): no thread runs yet.
  const std::vector<XrExtensionProperties> offered = runtime_extensions();
  if (offered.empty()) return explain(XR_ERROR_RUNTIME_UNAVAILABLE);
  if (!offers(offered, XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME))
    return Error{
        "The active OpenXR runtime does not draw with Vulkan (XR_KHR_vulkan_enable2): update it, or make "
        "another one active."};
  if (hands && !offers(offered, XR_EXT_HAND_TRACKING_EXTENSION_NAME))
    return Error{
        std::string("The active OpenXR runtime tracks no hands (XR_EXT_hand_tracking): update it, ") +
        kTakeControllers};
  std::vector<const char*> extensions{XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME};
  if (hands) extensions.push_back(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
  auto info = structure<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
  std::strcpy(info.applicationInfo.applicationName, "Fulcrum");
  std::strcpy(info.applicationInfo.engineName, "Fulcrum");
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.enabledExtensionNames = extensions.data();
  std::unique_ptr<Instance> made(new Instance);
  if (const XrResult code = xrCreateInstance(&info, &made->instance_); XR_FAILED(code)) {
    made->instance_ = XR_NULL_HANDLE;
    return explain(code);
  }
  auto runtime = structure<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
  if (XR_SUCCEEDED(xrGetInstanceProperties(made->instance_, &runtime)))
    made->runtime_ = std::string(runtime.runtimeName) + " " + version_text(runtime.runtimeVersion);
  if (const XrResult code = made->ask_for_system(); XR_FAILED(code)) return explain(code);
  auto tracking = structure<XrSystemHandTrackingPropertiesEXT>(XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT);
  auto headset = structure<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
  if (hands) headset.next = &tracking;
  if (XR_SUCCEEDED(xrGetSystemProperties(made->instance_, made->system_, &headset))) {
    made->headset_ = headset.systemName;
    made->largest_ = {headset.graphicsProperties.maxSwapchainImageWidth,
                      headset.graphicsProperties.maxSwapchainImageHeight};
  }
  if (hands && tracking.supportsHandTracking != XR_TRUE)
    return Error{"The headset, " + made->headset_ +
                 ", tracks no hands, or is told not to: switch that on in its settings, " + kTakeControllers};
  return made;
}

Instance::~Instance() {
  if (instance_ != XR_NULL_HANDLE) xrDestroyInstance(instance_);
}

XrResult Instance::ask_for_system() {
  auto info = structure<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
  info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  return xrGetSystem(instance_, &info, &system_);
}

bool Instance::find_headset() {
  const XrResult code = ask_for_system();
  if (code == XR_ERROR_FORM_FACTOR_UNAVAILABLE) return false;
  check(code, "look for the headset");
  return true;
}

VkExtent2D Instance::recommended_eye() const {
  std::array<XrViewConfigurationView, 2> views;
  views.fill(structure<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW));
  std::uint32_t count = 0;
  check(xrEnumerateViewConfigurationViews(instance_, system_, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO,
                                          static_cast<std::uint32_t>(views.size()), &count, views.data()),
        "say how large pictures are to be");
  // One size for both: they lie side by side in one picture.
  const VkExtent2D eye{std::max(views[0].recommendedImageRectWidth, views[1].recommendedImageRectWidth),
                       std::max(views[0].recommendedImageRectHeight, views[1].recommendedImageRectHeight)};
  if (eye.width == 0 || eye.height == 0)
    throw Failure(
        "The headset's runtime wants pictures of " + std::to_string(eye.width) + " x " +
        std::to_string(eye.height) +
        " pixels, which nothing can be drawn in: set its resolution, or make another runtime active.");
  return within(eye, largest_);
}

XrEnvironmentBlendMode Instance::blend_mode() const {
  constexpr XrViewConfigurationType kViews = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  constexpr const char* kDoing = "say how its pictures go with the room";
  std::uint32_t count = 0;
  check(xrEnumerateEnvironmentBlendModes(instance_, system_, kViews, 0, &count, nullptr), kDoing);
  std::vector<XrEnvironmentBlendMode> modes(count);
  check(xrEnumerateEnvironmentBlendModes(instance_, system_, kViews, count, &count, modes.data()), kDoing);
  const bool opaque =
      modes.empty() || std::ranges::find(modes, XR_ENVIRONMENT_BLEND_MODE_OPAQUE) != modes.end();
  return opaque ? XR_ENVIRONMENT_BLEND_MODE_OPAQUE : modes.front();
}

XrPath Instance::path(const char* name) const {
  XrPath path = XR_NULL_PATH;
  check(xrStringToPath(instance_, name, &path), "name a path");
  return path;
}

PFN_xrVoidFunction Instance::find(const char* name) const {
  PFN_xrVoidFunction found = nullptr;
  check(xrGetInstanceProcAddr(instance_, name, &found), name);
  return found;
}

VkResult Instance::create_instance(const VkInstanceCreateInfo& info, VkInstance* instance) {
  const auto create = function<PFN_xrCreateVulkanInstanceKHR>("xrCreateVulkanInstanceKHR");
  auto wanted = structure<XrVulkanInstanceCreateInfoKHR>(XR_TYPE_VULKAN_INSTANCE_CREATE_INFO_KHR);
  wanted.systemId = system_;
  wanted.pfnGetInstanceProcAddr = &vkGetInstanceProcAddr;
  wanted.vulkanCreateInfo = &info;
  VkResult code = VK_ERROR_INITIALIZATION_FAILED;
  check(create(instance_, &wanted, instance, &code), "start Vulkan");
  return code;
}

VkResult Instance::create_device(VkPhysicalDevice card, const VkDeviceCreateInfo& info, VkDevice* device) {
  const auto create = function<PFN_xrCreateVulkanDeviceKHR>("xrCreateVulkanDeviceKHR");
  auto wanted = structure<XrVulkanDeviceCreateInfoKHR>(XR_TYPE_VULKAN_DEVICE_CREATE_INFO_KHR);
  wanted.systemId = system_;
  wanted.pfnGetInstanceProcAddr = &vkGetInstanceProcAddr;
  wanted.vulkanPhysicalDevice = card;
  wanted.vulkanCreateInfo = &info;
  VkResult code = VK_ERROR_INITIALIZATION_FAILED;
  check(create(instance_, &wanted, device, &code), "start the graphics card");
  return code;
}

VkPhysicalDevice Instance::card(VkInstance instance) {
  // The runtime wants to have been asked before it lets a session begin.
  const auto require =
      function<PFN_xrGetVulkanGraphicsRequirements2KHR>("xrGetVulkanGraphicsRequirements2KHR");
  auto required = structure<XrGraphicsRequirementsVulkan2KHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN2_KHR);
  check(require(instance_, system_, &required), "say what it needs of Vulkan");
  const auto choose = function<PFN_xrGetVulkanGraphicsDevice2KHR>("xrGetVulkanGraphicsDevice2KHR");
  auto wanted = structure<XrVulkanGraphicsDeviceGetInfoKHR>(XR_TYPE_VULKAN_GRAPHICS_DEVICE_GET_INFO_KHR);
  wanted.systemId = system_;
  wanted.vulkanInstance = instance;
  VkPhysicalDevice card = VK_NULL_HANDLE;
  check(choose(instance_, &wanted, &card), "choose a graphics card");
  return card;
}

}  // namespace fulcrum::xr
