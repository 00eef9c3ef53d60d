// How a frame is recorded: shadow map, scene, ghost, tone mapping, overlay.

#include "engine/render/recording.h"
#include "engine/render/renderer.h"

namespace fulcrum::render {
namespace {

vulkan::ImageUse either(const vulkan::ImageUse& a, const vulkan::ImageUse& b) {
  return {a.stage | b.stage, a.access | b.access, VK_IMAGE_LAYOUT_UNDEFINED};
}

}  // namespace

void Renderer::record(VkCommandBuffer commands, OverlayPass* overlay) {
  namespace use = vulkan::use;
  if (plan_.shadow_size > 0 && shadow_stale_) {
    record_shadow(commands);
    shadow_stale_ = false;
  }
  const bool ghost = ghost_ && ghost_->shown();
  record_scene(commands, ghost);
  if (ghost) {
    vulkan::barrier(commands, targets_.depth.get(), kDepth, use::kDepthTarget, use::kSampled);
    ghost_->record_lines(commands, pipelines_, *geometry_);
  }
  vulkan::barrier(commands, targets_.scene.get(), kColour, use::kColourTarget, use::kSampled);
  record_tone(commands, ghost);
  if (overlay != nullptr)
    overlay->record(commands, {targets_.picture.view(), targets_.picture.extent(), generation_});
  vulkan::barrier(commands, targets_.picture.get(), kColour, use::kColourTarget, use::kCopySource);
}

void Renderer::record_shadow(VkCommandBuffer commands) {
  namespace use = vulkan::use;
  vulkan::barrier(commands, shadow_map_.get(), kDepth, discarded_after(use::kSampled), use::kDepthTarget);
  VkRenderingAttachmentInfo depth = attachment(shadow_map_.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                               VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_STORE);
  depth.clearValue.depthStencil.depth = 1.0F;
  begin(commands, shadow_map_.extent(), nullptr, &depth);
  bind(commands, pipelines_.shadow.get(), pipelines_.scene_layout.get(), scene_set_.get());
  geometry_->draw(commands, SceneGeometry::Which::casters);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, shadow_map_.get(), kDepth, use::kDepthTarget, use::kSampled);
}

void Renderer::record_scene(VkCommandBuffer commands, bool ghost) {
  namespace use = vulkan::use;
  const bool resolves = static_cast<bool>(targets_.samples);
  const vulkan::Image& drawn = resolves ? targets_.samples : targets_.scene;
  vulkan::barrier(commands, targets_.scene.get(), kColour, discarded_after(use::kSampled),
                  use::kColourTarget);
  if (resolves)
    vulkan::barrier(commands, drawn.get(), kColour, discarded_after(use::kColourTarget), use::kColourTarget);
  vulkan::barrier(commands, targets_.depth.get(), kDepth,
                  discarded_after(either(use::kDepthTarget, use::kSampled)), use::kDepthTarget);

  // Every pixel is drawn, by the background if by nothing else: no clear.
  VkRenderingAttachmentInfo colour =
      attachment(drawn.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 resolves ? VK_ATTACHMENT_STORE_OP_DONT_CARE : VK_ATTACHMENT_STORE_OP_STORE);
  if (resolves) {
    colour.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    colour.resolveImageView = targets_.scene.view();
    colour.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  }
  VkRenderingAttachmentInfo depth =
      attachment(targets_.depth.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR,
                 ghost ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE);
  depth.clearValue.depthStencil.depth = 0.0F;  // reversed: infinitely far
  begin(commands, targets_.scene.extent(), &colour, &depth);
  if (plan_.surfaces) {
    bind(commands, pipelines_.surfaces.get(), pipelines_.scene_layout.get(), scene_set_.get());
    geometry_->draw(commands, SceneGeometry::Which::all);
  }
  bind(commands, pipelines_.background.get(), pipelines_.scene_layout.get(), scene_set_.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  if (markers_shown_ > 0) record_markers(commands);
  vkCmdEndRendering(commands);
}

void Renderer::record_markers(VkCommandBuffer commands) {
  bind(commands, pipelines_.markers.get(), pipelines_.scene_layout.get(), scene_set_.get());
  const auto draw = [&](VkCompareOp passes, float visibility) {
    vkCmdSetDepthCompareOp(commands, passes);
    vkCmdPushConstants(commands, pipelines_.scene_layout.get(), VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(visibility), &visibility);
    vkCmdDraw(commands, 6, markers_shown_, 0, 0);
  };
  draw(VK_COMPARE_OP_GREATER, 1.0F);
  draw(VK_COMPARE_OP_LESS_OR_EQUAL, 0.22F);  // behind something: a trainee must still find the way
}

void Renderer::record_tone(VkCommandBuffer commands, bool ghost) {
  namespace use = vulkan::use;
  vulkan::barrier(commands, targets_.picture.get(), kColour, discarded_after(use::kCopySource),
                  use::kColourTarget);
  const VkRenderingAttachmentInfo colour =
      attachment(targets_.picture.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_ATTACHMENT_LOAD_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, targets_.picture.extent(), &colour, nullptr);
  bind(commands, pipelines_.tone.get(), pipelines_.tone_layout.get(), tone_set_.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  if (ghost) ghost_->record_over(commands, pipelines_);
  vkCmdEndRendering(commands);
}

}  // namespace fulcrum::render
