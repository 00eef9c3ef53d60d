// Images in Vulkan, on the program's own device, as a runtime of this machine makes them.

#include <cstring>
#include <functional>
#include <stdexcept>

#include "tests/xr/runtime/headset.h"

namespace runtime {
namespace {

void check(VkResult code) {
  if (code != VK_SUCCESS) throw std::runtime_error("Vulkan says " + std::to_string(code));
}

std::uint32_t memory_type(std::uint32_t possible, VkMemoryPropertyFlags wanted) {
  VkPhysicalDeviceMemoryProperties properties{};
  vkGetPhysicalDeviceMemoryProperties(headset->session->vulkan.physicalDevice, &properties);
  for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i)
    if ((possible & (1U << i)) != 0 && (properties.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
  throw std::runtime_error("no memory is of the kind that is wanted");
}

VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = needs.size;
  info.memoryTypeIndex = memory_type(needs.memoryTypeBits, wanted);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(vkAllocateMemory(headset->session->vulkan.device, &info, nullptr, &memory));
  return memory;
}

void run(const std::function<void(VkCommandBuffer)>& record) {
  const Session& session = *headset->session;
  const VkDevice device = session.vulkan.device;
  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = session.pool;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(device, &info, &commands));
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  check(vkBeginCommandBuffer(commands, &begin));
  record(commands);
  check(vkEndCommandBuffer(commands));
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  check(vkQueueSubmit(session.queue, 1, &submit, VK_NULL_HANDLE));
  check(vkQueueWaitIdle(session.queue));
  vkFreeCommandBuffers(device, session.pool, 1, &commands);
}

void change_layout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
  barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                       nullptr, 0, nullptr, 1, &barrier);
}

}  // namespace

void make_images(Swapchain& swapchain) {
  const VkDevice device = headset->session->vulkan.device;
  for (int i = 0; i < 3; ++i) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = swapchain.format;
    info.extent = {swapchain.width, swapchain.height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                 VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VkImage image = VK_NULL_HANDLE;
    check(vkCreateImage(device, &info, nullptr, &image));
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device, image, &needs);
    swapchain.images.push_back(image);
    swapchain.memory.push_back(allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT));
    check(vkBindImageMemory(device, image, swapchain.memory.back(), 0));
  }
}

void destroy_images(Swapchain& swapchain) {
  const VkDevice device = headset->session->vulkan.device;
  for (VkImage image : swapchain.images) vkDestroyImage(device, image, nullptr);
  for (VkDeviceMemory memory : swapchain.memory) vkFreeMemory(device, memory, nullptr);
}

void spoil(const Swapchain& swapchain, std::size_t image) {
  run([&](VkCommandBuffer commands) {
    change_layout(commands, swapchain.images[image], VK_IMAGE_LAYOUT_UNDEFINED,
                  VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkClearColorValue colour{};
    for (std::size_t i = 0; i < 3; ++i) colour.float32[i] = static_cast<float>(kUnwritten[i]) / 255.0F;
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands, swapchain.images[image], VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &colour, 1,
                         &all);
    change_layout(commands, swapchain.images[image], VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                  VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  });
}

std::vector<std::uint8_t> read(const Swapchain& swapchain) {
  const VkDevice device = headset->session->vulkan.device;
  const VkImage image = swapchain.images[*swapchain.released];
  const VkDeviceSize bytes = VkDeviceSize{4} * swapchain.width * swapchain.height;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vkCreateBuffer(device, &info, nullptr, &buffer));
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device, buffer, &needs);
  // A graphics card's memory is slow to read; this is the processor's.
  const VkDeviceMemory memory =
      allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT |
                          VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
  check(vkBindBufferMemory(device, buffer, memory, 0));
  run([&](VkCommandBuffer commands) {
    change_layout(commands, image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                  VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {swapchain.width, swapchain.height, 1};
    vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &copy);
    change_layout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                  VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  });
  std::vector<std::uint8_t> pixels(bytes);
  void* mapped = nullptr;
  check(vkMapMemory(device, memory, 0, bytes, 0, &mapped));
  std::memcpy(pixels.data(), mapped, bytes);
  vkDestroyBuffer(device, buffer, nullptr);
  vkFreeMemory(device, memory, nullptr);
  return pixels;
}

}  // namespace runtime
