#pragma once
// A buffer and its memory.

#include <cstddef>
#include <span>

#include "engine/vulkan/device.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::vulkan {

class Buffer {
public:
  Buffer() = default;
  // Throws Failure where memory runs out. Size in bytes, more than 0.
  Buffer(Device& device, VkDeviceSize size, VkBufferUsageFlags usage, Place place);

  VkBuffer get() const { return buffer_.get(); }
  VkDeviceSize size() const { return size_; }
  // What the program writes (Place::upload) or reads (Place::readback); coherent, so no flush.
  std::byte* mapped() const { return allocation_.mapped(); }

private:
  Allocation allocation_;
  BufferHandle buffer_;  // after the allocation: destroyed before the memory is given back
  VkDeviceSize size_ = 0;
};

// A buffer on the device that holds `bytes`; returns when they have arrived. Throws Failure.
Buffer upload(Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage);

}  // namespace fulcrum::vulkan
