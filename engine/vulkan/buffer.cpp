#include "engine/vulkan/buffer.h"

#include <cstring>

#include "engine/vulkan/commands.h"

namespace fulcrum::vulkan {

Buffer::Buffer(Device& device, VkDeviceSize size, VkBufferUsageFlags usage, Place place) : size_(size) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = size;
  info.usage = usage;
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vkCreateBuffer(device.get(), &info, nullptr, &buffer), "make a buffer");
  buffer_ = BufferHandle(device.get(), buffer);

  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device.get(), buffer, &needs);
  allocation_ = device.memory().allocate(needs, place, false);
  check(vkBindBufferMemory(device.get(), buffer, allocation_.memory(), allocation_.offset()),
        "place a buffer");
}

Buffer upload(Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage) {
  const Buffer staging(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Place::upload);
  std::memcpy(staging.mapped(), bytes.data(), bytes.size());
  Buffer made(device, bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, Place::device);
  Commands(device).run([&](VkCommandBuffer commands) {
    VkBufferCopy copy{};
    copy.size = bytes.size();
    vkCmdCopyBuffer(commands, staging.get(), made.get(), 1, &copy);
  });
  return made;
}

}  // namespace fulcrum::vulkan
