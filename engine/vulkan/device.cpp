#include "engine/vulkan/device.h"

#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <optional>

namespace fulcrum::vulkan {
namespace {

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  devices.resize(count);
  return devices;
}

const char* kind_of(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "graphics card";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "software";
    default:
      return "other";
  }
}

int preference(const std::string& kind) {
  const std::array<const char*, 4> order = {"graphics card", "integrated", "virtual", "other"};
  const auto found = std::find(order.begin(), order.end(), kind);
  return static_cast<int>(found - order.begin());  // "software" comes last
}

// The first queue family that can draw and, with a surface, show.
std::optional<std::uint32_t> drawing_family(VkPhysicalDevice device, VkSurfaceKHR surface) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i) {
    VkBool32 shows = VK_TRUE;
    if (surface != VK_NULL_HANDLE) vkGetPhysicalDeviceSurfaceSupportKHR(device, i, surface, &shows);
    if ((families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0 && shows == VK_TRUE) return i;
  }
  return std::nullopt;
}

std::string why_not(VkPhysicalDevice device, const VkPhysicalDeviceProperties& properties) {
  if (properties.apiVersion < VK_API_VERSION_1_3) {
    return "its driver offers Vulkan " + std::to_string(VK_API_VERSION_MAJOR(properties.apiVersion)) + "." +
           std::to_string(VK_API_VERSION_MINOR(properties.apiVersion)) + ", Fulcrum needs 1.3";
  }
  if (!drawing_family(device, VK_NULL_HANDLE)) return "it computes only, it does not draw";
  return {};  // dynamic rendering and synchronization2 are part of every Vulkan 1.3
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() < 6 &&
         std::all_of(
             text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// As `--gpu` takes it; empty, and so the best one, where the creator has none.
std::string number_of_card(const Instance& instance, Creator& creator) {
  const std::vector<VkPhysicalDevice> all = physical_devices(instance.get());
  const auto found = std::find(all.begin(), all.end(), creator.card(instance.get()));
  return found == all.end() ? "" : std::to_string(found - all.begin());
}

}  // namespace

std::vector<DeviceInfo> list_devices(const Instance& instance) {
  std::vector<DeviceInfo> list;
  for (VkPhysicalDevice device : physical_devices(instance.get())) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    list.push_back({static_cast<std::uint32_t>(list.size()), properties.deviceName,
                    kind_of(properties.deviceType), why_not(device, properties)});
  }
  return list;
}

std::string describe(const std::vector<DeviceInfo>& devices) {
  if (devices.empty())
    return "No Vulkan device: install the driver of the graphics card, or mesa-vulkan-drivers.\n";
  std::string table;
  for (const DeviceInfo& device : devices) {
    table += std::to_string(device.index) + "  " + device.name + " (" + device.kind + ")";
    table += device.why_not.empty() ? "\n" : ": not usable, " + device.why_not + "\n";
  }
  return table;
}

Result<DeviceInfo> choose(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
  const DeviceInfo* chosen = nullptr;
  for (const DeviceInfo& device : devices) {
    if (wanted.empty()) {
      const bool better = chosen == nullptr || preference(device.kind) < preference(chosen->kind);
      chosen = device.why_not.empty() && better ? &device : chosen;
    } else if (is_number(wanted) ? device.index == std::stoul(wanted)
                                 : lower(device.name).find(lower(wanted)) != std::string::npos) {
      chosen = &device;
      break;
    }
  }
  if (chosen == nullptr) {
    const std::string what = wanted.empty() ? "No Vulkan device can draw for Fulcrum"
                                            : "No Vulkan device is called \"" + wanted + "\"";
    return Error{what + "; there are:\n" + describe(devices)};
  }
  if (!chosen->why_not.empty()) {
    return Error{"Fulcrum cannot draw with " + chosen->name + ": " + chosen->why_not +
                 ". Update its driver, or choose another one; `--gpu list` names them."};
  }
  return *chosen;
}

Result<std::unique_ptr<Device>> Device::create(const Instance& instance, const std::string& wanted,
                                               VkSurfaceKHR surface, Creator* creator) {
  const Result<DeviceInfo> chosen =
      choose(list_devices(instance), creator != nullptr ? number_of_card(instance, *creator) : wanted);
  if (!chosen) return chosen.error();
  std::unique_ptr<Device> made(new Device);
  made->info_ = *chosen;
  made->instance_ = instance.get();
  made->physical_ = physical_devices(instance.get())[made->info_.index];
  const std::optional<std::uint32_t> family = drawing_family(made->physical_, surface);
  if (!family) {
    return Error{made->info_.name +
                 " cannot show pictures in a window here: choose another device with --gpu, or run "
                 "without a window."};
  }
  made->queue_family_ = *family;

  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = *family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;

  VkPhysicalDeviceVulkan13Features features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  features.dynamicRendering = VK_TRUE;
  features.synchronization2 = VK_TRUE;

  VkPhysicalDeviceFeatures offered{}, wanted_features{};
  vkGetPhysicalDeviceFeatures(made->physical_, &offered);
  wanted_features.samplerAnisotropy = offered.samplerAnisotropy;
  made->has_anisotropy_ = offered.samplerAnisotropy == VK_TRUE;
  wanted_features.dualSrcBlend = offered.dualSrcBlend;
  made->blends_by_two_ = offered.dualSrcBlend == VK_TRUE;

  const char* swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &features;
  info.pEnabledFeatures = &wanted_features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = surface == VK_NULL_HANDLE ? 0 : 1;
  info.ppEnabledExtensionNames = &swapchain;
  const VkResult code = creator != nullptr ? creator->create_device(made->physical_, info, &made->device_)
                                           : vkCreateDevice(made->physical_, &info, nullptr, &made->device_);
  if (code != VK_SUCCESS) {
    made->device_ = VK_NULL_HANDLE;
    return Error{made->info_.name + " did not start (" + name_of(code) +
                 "): update its driver, or choose another device with --gpu."};
  }
  vkGetDeviceQueue(made->device_, *family, 0, &made->queue_);
  made->memory_ = std::make_unique<Memory>(made->physical_, made->device_);
  return made;
}

Device::~Device() {
  if (device_ != VK_NULL_HANDLE) {
    vkDeviceWaitIdle(device_);
    memory_.reset();
    vkDestroyDevice(device_, nullptr);
  }
}

}  // namespace fulcrum::vulkan
