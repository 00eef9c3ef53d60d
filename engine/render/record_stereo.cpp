// How two eyes' views of the scene become one picture.

#include "engine/render/recording.h"
#include "engine/render/renderer.h"

namespace fulcrum::render {

void Renderer::record_stereo(VkCommandBuffer commands, OverlayPass* overlay) {
  namespace use = vulkan::use;
  record_eye(commands, main_, stereo_->eyes[0]);
  record_eye(commands, stereo_->right, stereo_->eyes[1]);
  if (plan_.screen_layer) record_screen(commands, overlay);
  vulkan::barrier(commands, picture_.get(), kColour, discarded_after(use::kCopySource), use::kColourTarget);
  const VkRenderingAttachmentInfo colour =
      attachment(picture_.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, picture_.extent(), &colour, nullptr);
  bind(commands, pipelines_.stereo.get(), pipelines_.stereo_layout.get(), stereo_->set.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  vkCmdEndRendering(commands);
}

// What it sees, finished for the screen.
void Renderer::record_eye(VkCommandBuffer commands, const View& view, const vulkan::Image& finished) {
  namespace use = vulkan::use;
  vulkan::barrier(commands, finished.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
  const VkRenderingAttachmentInfo colour =
      attachment(finished.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, finished.extent(), &colour, nullptr);
  record_tone(commands, view);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, finished.get(), kColour, use::kColourTarget, use::kSampled);
}

// Drawn once for both eyes: it has no depth.
void Renderer::record_screen(VkCommandBuffer commands, OverlayPass* overlay) {
  namespace use = vulkan::use;
  const vulkan::Image& screen = stereo_->screen;
  vulkan::barrier(commands, screen.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
  // Cleared to nothing at all: what is drawn over that stays premultiplied.
  const VkRenderingAttachmentInfo colour =
      attachment(screen.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, screen.extent(), &colour, nullptr);
  if (inset_) record_inset(commands);
  vkCmdEndRendering(commands);
  if (overlay != nullptr) overlay->record(commands, {screen.view(), screen.extent(), generation_});
  vulkan::barrier(commands, screen.get(), kColour, use::kColourTarget, use::kSampled);
}

}  // namespace fulcrum::render
