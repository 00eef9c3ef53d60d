#pragma once
// What is said to who wears a headset: the panels of a window, on a sheet that stands in its space.

#include <memory>
#include <string>

#include "engine/headset/placement.h"
#include "engine/ui/overlay.h"
#include "engine/vulkan/commands.h"
#include "engine/vulkan/image.h"

namespace fulcrum::headset {

class Panel {
public:
  static constexpr VkExtent2D kSize{1280, 720};  // pixels

  // The device must outlive the panel.
  static Result<std::unique_ptr<Panel>> create(vulkan::Device& gpu);

  // Into an image of that size that a swapchain of the headset gave.
  std::optional<Error> draw(const ui::OverlayState& state, VkImage target);

  // Empty, or one line to print: that the font is missing.
  const std::string& font_note() const { return overlay_->font_note(); }

private:
  Panel(vulkan::Device& gpu, std::unique_ptr<ui::Overlay> overlay);

  std::unique_ptr<ui::Overlay> overlay_;
  vulkan::Commands commands_;
  vulkan::Image sheet_;  // premultiplied
};

// Where the sheet stands, and how wide it is.
struct PanelPlace {
  Pose X_LP;         // its middle; it faces along its z
  double width = 0;  // m in L
};

// Upright through what the view looks at, and so wide that its panels are left and right of that.
PanelPlace place_panel(const render::Camera& view, const Placement& placement);

}  // namespace fulcrum::headset
