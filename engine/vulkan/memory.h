#pragma once
// Device memory in blocks: a driver allows few allocations, a scene has many buffers and images.

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/vulkan/free_list.h"

namespace fulcrum::vulkan {

// Where memory should lie.
enum class Place {
  device,   // fastest for the device; the program cannot reach it
  upload,   // written by the program, read by the device; mapped
  readback  // written by the device, read by the program; mapped, cached where there is such memory
};

class Memory;

// A piece of a block; gives itself back.
class Allocation {
public:
  Allocation() = default;
  Allocation(Allocation&& other) noexcept;
  Allocation& operator=(Allocation&& other) noexcept;
  ~Allocation();

  VkDeviceMemory memory() const;
  VkDeviceSize offset() const { return offset_; }
  std::byte* mapped() const;  // null for Place::device

private:
  friend class Memory;
  struct Block;

  std::shared_ptr<Block> block_;  // the last piece of a block frees it
  VkDeviceSize offset_ = 0;
  VkDeviceSize size_ = 0;
};

class Memory {
public:
  Memory(VkPhysicalDevice physical, VkDevice device);
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  // `image`: for an optimally tiled image; images and buffers never share a block, so that no page holds
  // both (VkPhysicalDeviceLimits::bufferImageGranularity). Throws Failure where no memory fits.
  Allocation allocate(const VkMemoryRequirements& needs, Place place, bool image);

private:
  std::uint32_t type_for(std::uint32_t allowed, Place place) const;
  std::shared_ptr<Allocation::Block> new_block(std::uint32_t type, VkDeviceSize size, bool image, bool map);

  VkDevice device_;
  VkPhysicalDeviceMemoryProperties properties_{};
  std::vector<std::weak_ptr<Allocation::Block>> blocks_;
};

}  // namespace fulcrum::vulkan
