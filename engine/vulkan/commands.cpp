#include "engine/vulkan/commands.h"

#include <chrono>
#include <cstdint>
#include <limits>

namespace fulcrum::vulkan {

Commands::Commands(Device& device) : device_(device) {
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.queueFamilyIndex = device.queue_family();
  VkCommandPool pool_object = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device.get(), &pool, nullptr, &pool_object), "make a command pool");
  pool_ = CommandPoolHandle(device.get(), pool_object);

  VkCommandBufferAllocateInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  buffer.commandPool = pool_object;
  buffer.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  buffer.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device.get(), &buffer, &buffer_), "make a command buffer");

  VkFenceCreateInfo fence{};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  VkFence fence_object = VK_NULL_HANDLE;
  check(vkCreateFence(device.get(), &fence, nullptr, &fence_object), "make a fence");
  done_ = FenceHandle(device.get(), fence_object);
}

void Commands::run(const std::function<void(VkCommandBuffer)>& record, const SubmitSemaphores& semaphores,
                   const std::function<void()>& before_submission) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  check(vkResetCommandPool(device_.get(), pool_.get(), 0), "reuse a command buffer");
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(buffer_, &begin), "record a frame");
  record(buffer_);
  check(vkEndCommandBuffer(buffer_), "record a frame");

  VkCommandBufferSubmitInfo commands{};
  commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
  commands.commandBuffer = buffer_;
  VkSemaphoreSubmitInfo wait{};
  wait.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
  wait.semaphore = semaphores.wait;
  wait.stageMask = semaphores.wait_stage;
  VkSemaphoreSubmitInfo signal{};
  signal.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
  signal.semaphore = semaphores.signal;
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;

  VkSubmitInfo2 submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  submit.waitSemaphoreInfoCount = semaphores.wait == VK_NULL_HANDLE ? 0 : 1;
  submit.pWaitSemaphoreInfos = &wait;
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &commands;
  submit.signalSemaphoreInfoCount = semaphores.signal == VK_NULL_HANDLE ? 0 : 1;
  submit.pSignalSemaphoreInfos = &signal;
  if (before_submission) before_submission();
  const Clock::time_point submission = Clock::now();
  const VkResult submitted =
      device_.lost() ? VK_ERROR_DEVICE_LOST : vkQueueSubmit2(device_.queue(), 1, &submit, done_.get());
  check(submitted, "submit a frame");
  const VkFence fence = done_.get();
  check(vkWaitForFences(device_.get(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
        "finish a frame");
  check(vkResetFences(device_.get(), 1, &fence), "reuse a fence");
  const Clock::time_point done = Clock::now();
  last_run_s_ = std::chrono::duration<double>(done - start).count();
  last_submission_s_ = std::chrono::duration<double>(done - submission).count();
}

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& from,
             const ImageUse& to) {
  VkImageMemoryBarrier2 change{};
  change.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  change.srcStageMask = from.stage;
  change.srcAccessMask = from.access;
  change.oldLayout = from.layout;
  change.dstStageMask = to.stage;
  change.dstAccessMask = to.access;
  change.newLayout = to.layout;
  change.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.image = image;
  change.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
  VkDependencyInfo dependency{};
  dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &change;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace fulcrum::vulkan
