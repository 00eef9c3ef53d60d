#include "engine/headset/panel.h"

#include <algorithm>
#include <utility>

#include "engine/xr/swapchain.h"

namespace fulcrum::headset {
namespace {

constexpr double kWide = 1.1;  // of its distance: 58 degrees
// Of the renderers' images none has this one: they count from 1 on.
constexpr std::uint64_t kSheet = ~std::uint64_t{0};

vulkan::Image make_sheet(vulkan::Device& gpu) {
  return {gpu,
          {render::kPictureFormat, Panel::kSize,
           VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}};
}

// Nothing at all: what is drawn over that stays premultiplied.
void clear(VkCommandBuffer commands, const vulkan::Image& sheet) {
  VkRenderingAttachmentInfo colour{};
  colour.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  colour.imageView = sheet.view();
  colour.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  VkRenderingInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  info.renderArea.extent = sheet.extent();
  info.layerCount = 1;
  info.colorAttachmentCount = 1;
  info.pColorAttachments = &colour;
  vkCmdBeginRendering(commands, &info);
  vkCmdEndRendering(commands);
}

}  // namespace

Result<std::unique_ptr<Panel>> Panel::create(vulkan::Device& gpu) {
  auto overlay = ui::Overlay::create(gpu);
  if (!overlay) return overlay.error();
  try {
    return std::unique_ptr<Panel>(new Panel(gpu, std::move(*overlay)));
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
}

Panel::Panel(vulkan::Device& gpu, std::unique_ptr<ui::Overlay> overlay)
    : overlay_(std::move(overlay)), commands_(gpu), sheet_(make_sheet(gpu)) {}

std::optional<Error> Panel::draw(const ui::OverlayState& state, VkImage target) {
  namespace use = vulkan::use;
  constexpr VkImageAspectFlags kColour = VK_IMAGE_ASPECT_COLOR_BIT;
  if (auto error = overlay_->prepare(state, {kSize.width, kSize.height})) return error;
  try {
    commands_.run([&](VkCommandBuffer commands) {
      const vulkan::ImageUse before{use::kCopySource.stage, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
      vulkan::barrier(commands, sheet_.get(), kColour, before, use::kColourTarget);
      clear(commands, sheet_);
      vulkan::barrier(commands, sheet_.get(), kColour, use::kColourTarget, use::kColourTarget);
      overlay_->record(commands, {sheet_.view(), sheet_.extent(), kSheet});
      vulkan::barrier(commands, sheet_.get(), kColour, use::kColourTarget, use::kCopySource);
      xr::copy_to(commands, sheet_.get(), target, kSize);
    });
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
  return std::nullopt;
}

PanelPlace place_panel(const render::Camera& view, const Placement& placement) {
  const Vec3 target_W(static_cast<double>(view.target.x), static_cast<double>(view.target.y),
                      static_cast<double>(view.target.z));
  const glm::vec3 ahead = glm::normalize(view.target - view.eye);
  const Vec3 ahead_W(static_cast<double>(ahead.x), static_cast<double>(ahead.y),
                     static_cast<double>(ahead.z));
  const double away = static_cast<double>(glm::length(view.target - view.eye)) * placement.scale;
  return {{heading(placement.X_WL.q.conjugate() * ahead_W),
           placement.scale * (placement.X_WL.inverse() * target_W)},
          kWide * std::max(away, kNearest)};
}

}  // namespace fulcrum::headset
