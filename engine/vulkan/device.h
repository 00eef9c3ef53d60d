#pragma once
// Which graphics device draws, and the one queue that is used on it.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/vulkan/instance.h"
#include "engine/vulkan/memory.h"

namespace fulcrum::vulkan {

// What `--gpu list` shows.
struct DeviceInfo {
  std::uint32_t index = 0;
  std::string name;
  std::string kind;     // "graphics card", "integrated", "virtual", "software", "other"
  std::string why_not;  // empty: Fulcrum can draw with it
};

std::vector<DeviceInfo> list_devices(const Instance& instance);

// The table of `--gpu list`, one line a device; a sentence where there is none.
std::string describe(const std::vector<DeviceInfo>& devices);

// The device that `wanted` means: empty, the best one (a real graphics card before a software rasteriser,
// then the order of the driver); a number, the one with that index; else the first whose name contains it,
// whatever the case. A sentence names the devices where none fits.
Result<DeviceInfo> choose(const std::vector<DeviceInfo>& devices, const std::string& wanted);

class Device {
public:
  // `wanted` as in choose(). With a surface, the device must be able to show pictures on it.
  // The instance must outlive the device, and the device all that is made on it. creator: then its card, and
  // nothing is wanted.
  static Result<std::unique_ptr<Device>> create(const Instance& instance, const std::string& wanted,
                                                VkSurfaceKHR surface = VK_NULL_HANDLE,
                                                Creator* creator = nullptr);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physical() const { return physical_; }
  VkDevice get() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return queue_family_; }
  Memory& memory() { return *memory_; }
  const DeviceInfo& info() const { return info_; }
  bool has_anisotropy() const { return has_anisotropy_; }
  bool blends_by_two() const { return blends_by_two_; }

  // From here on all that is submitted fails as on a card that is gone: to see what follows.
  void lose() { lost_ = true; }
  bool lost() const { return lost_; }

private:
  Device() = default;

  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t queue_family_ = 0;
  DeviceInfo info_;
  bool has_anisotropy_ = false;  // textures seen aslant can be sampled along the slant
  bool blends_by_two_ = false;   // a pixel's shader may give two colours to blend by (dualSrcBlend)
  bool lost_ = false;
  std::unique_ptr<Memory> memory_;
};

}  // namespace fulcrum::vulkan
