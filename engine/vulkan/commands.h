#pragma once
// One command buffer that is recorded, submitted and waited for: Fulcrum keeps a single frame in flight,
// because a trainee should see the newest pose and recording a frame takes microseconds.

#include <functional>

#include "engine/vulkan/device.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::vulkan {

// What a submission waits for and signals besides its fence: the window's side of a frame. Null: nothing.
struct SubmitSemaphores {
  VkSemaphore wait = VK_NULL_HANDLE;
  VkPipelineStageFlags2 wait_stage = VK_PIPELINE_STAGE_2_NONE;
  VkSemaphore signal = VK_NULL_HANDLE;
};

class Commands {
public:
  // Throws Failure.
  explicit Commands(Device& device);

  // Records with `record`, submits, and returns when the device is done. before_submission: writes what the
  // device is to read at the latest moment; none: nothing. Throws Failure.
  void run(const std::function<void(VkCommandBuffer)>& record, const SubmitSemaphores& semaphores = {},
           const std::function<void()>& before_submission = {});

  // How long the last run took, from recording to the device being done (s).
  double last_run_s() const { return last_run_s_; }
  // The same from its submission.
  double last_submission_s() const { return last_submission_s_; }

private:
  Device& device_;
  CommandPoolHandle pool_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;  // freed with its pool
  FenceHandle done_;
  double last_run_s_ = 0.0;
  double last_submission_s_ = 0.0;
};

// One side of an image barrier.
struct ImageUse {
  VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 access = VK_ACCESS_2_NONE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  // as `from`: the content is not needed
};

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& from,
             const ImageUse& to);

// The uses that frames consist of.
namespace use {
constexpr ImageUse kColourTarget{
    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
    VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
constexpr ImageUse kDepthTarget{
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
constexpr ImageUse kSampled{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
constexpr ImageUse kCopySource{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
constexpr ImageUse kCopyTarget{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr ImageUse kPresented{VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};
}  // namespace use

}  // namespace fulcrum::vulkan
