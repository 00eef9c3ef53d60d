#include "engine/vulkan/instance.h"

#include <vulkan/vulkan.h>

#include <array>
#include <cstring>

namespace fulcrum::vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
  static_cast<MessageLog*>(log)->add(data->pMessage);
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info(MessageLog* log) {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  // Not GENERAL: the loader reports drivers of absent hardware there, which says nothing about Fulcrum.
  info.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = on_message;
  info.pUserData = log;
  return info;
}

bool layer_installed(const char* name) {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  for (const VkLayerProperties& layer : layers)
    if (std::strcmp(layer.layerName, name) == 0) return true;
  return false;
}

Error explain(VkResult code) {
  switch (code) {
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return {
          "No Vulkan driver is installed: install the one of the graphics card, or, to draw without a card, "
          "mesa-vulkan-drivers (apt install mesa-vulkan-drivers)."};
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return {
          "The Vulkan driver cannot draw into windows of this desktop: update it, or run without a window."};
    default:
      return {"Vulkan did not start (" + name_of(code) +
              "): update the graphics driver, or install mesa-vulkan-drivers."};
  }
}

}  // namespace

void MessageLog::add(std::string message) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(message));
}

std::vector<std::string> MessageLog::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

Result<Instance> Instance::create(const InstanceOptions& options) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "Fulcrum";
  application.apiVersion = VK_API_VERSION_1_3;

  std::vector<const char*> extensions;
  for (const std::string& extension : options.extensions) extensions.push_back(extension.c_str());

  Instance made;
  VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(made.log_.get());
  const std::array<VkValidationFeatureEnableEXT, 1> enabled = {
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{};
  features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  features.pNext = &messenger;  // messages about vkCreateInstance itself
  features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size());
  features.pEnabledValidationFeatures = enabled.data();

  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  if (options.validation) {
    if (!layer_installed(kValidationLayer))
      return Error{"The Vulkan validation layers are not installed: apt install vulkan-validationlayers."};
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.pNext = &features;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
  }
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();

  const VkResult code = options.creator != nullptr ? options.creator->create_instance(info, &made.instance_)
                                                   : vkCreateInstance(&info, nullptr, &made.instance_);
  if (code != VK_SUCCESS) {
    made.instance_ = VK_NULL_HANDLE;
    return explain(code);
  }
  if (options.validation) {
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(made.instance_, "vkCreateDebugUtilsMessengerEXT"));
    if (create == nullptr || create(made.instance_, &messenger, nullptr, &made.messenger_) != VK_SUCCESS)
      return Error{"The Vulkan validation layers cannot report messages: reinstall vulkan-validationlayers."};
  }
  return made;
}

Instance::Instance(Instance&& other) noexcept
    : instance_(std::exchange(other.instance_, nullptr)),
      messenger_(std::exchange(other.messenger_, VkDebugUtilsMessengerEXT{VK_NULL_HANDLE})),
      log_(std::move(other.log_)) {}

Instance& Instance::operator=(Instance&& other) noexcept {
  std::swap(instance_, other.instance_);
  std::swap(messenger_, other.messenger_);
  std::swap(log_, other.log_);
  return *this;
}

Instance::~Instance() {
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance_, messenger_, nullptr);
  }
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

}  // namespace fulcrum::vulkan
