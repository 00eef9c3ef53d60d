#pragma once
// A window that is drawn into: first cards that say what takes so long, then a scene.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/cli/run_options.h"
#include "engine/app/settings/settings.h"
#include "engine/render/renderer.h"
#include "engine/ui/overlay.h"
#include "engine/ui/window.h"
#include "haptics/math/result.h"

namespace fulcrum::app {

class WindowStage {
public:
  // It is seen once there is something in it. Errors: no display, no Vulkan.
  static Result<std::unique_ptr<WindowStage>> create(const std::string& title, const RunOptions& options,
                                                     const Settings& settings);

  // Until the screen has a place for another picture.
  std::optional<Error> wait();
  // Delivers events, too. False: the window is to be closed. The first while there is no scene; frame: of the
  // scene there is, or of none.
  Result<bool> show(const ui::Busy& busy);
  Result<bool> show(const ui::OverlayState& state, render::FrameState frame);
  // From here on this is what is drawn; the window keeps what it shows until the first frame.
  std::optional<Error> set_scene(const render::VisualDesc& desc, const render::Quality& quality);

  // Back to none.
  std::optional<Error> clear_scene() { return set_scene({}, kCardQuality); }

  const Settings& settings() const { return settings_; }
  void set_settings(const Settings& settings) { settings_ = settings; }
  // What is seen in the middle between the eyes, where there are two.
  render::Camera seen(const render::Camera& camera) const { return seen_by_middle(stereo_, camera); }

  ui::Window& window() { return *window_; }
  ui::Overlay& overlay() { return *overlay_; }
  render::Renderer& renderer() { return *renderer_; }
  vulkan::Swapchain& swapchain() { return *swapchain_; }
  vulkan::Device& gpu() { return *gpu_; }
  // What Vulkan's validation layers have said so far, if options asked for them.
  std::vector<std::string> validation_messages() const { return instance_->messages(); }

private:
  static constexpr render::Quality kCardQuality{1, 0, 1.0F};

  WindowStage() = default;

  Settings settings_;
  std::optional<render::Stereo> stereo_;

  // In the order in which they need each other; destroyed backwards.
  std::unique_ptr<ui::Window> window_;
  std::unique_ptr<vulkan::Instance> instance_;
  std::unique_ptr<vulkan::Surface> surface_;
  std::unique_ptr<vulkan::Device> gpu_;
  std::unique_ptr<vulkan::Swapchain> swapchain_;
  std::unique_ptr<ui::Overlay> overlay_;
  std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace fulcrum::app
