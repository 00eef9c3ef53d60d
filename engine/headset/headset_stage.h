#pragma once
// What a headset's pictures are drawn with, from before there is a scene until the program ends: its runtime,
// Vulkan, and where there is a display, a window that mirrors them.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/cli/run_options.h"
#include "engine/app/settings/settings.h"
#include "engine/render/renderer.h"
#include "engine/ui/window.h"
#include "engine/xr/instance.h"

namespace fulcrum::headset {

class HeadsetStage {
public:
  // Errors: no runtime, no headset, no Vulkan.
  static Result<std::unique_ptr<HeadsetStage>> create(const std::string& title,
                                                      const app::RunOptions& options);

  // From here on this is what is drawn, for both eyes side by side.
  std::optional<Error> set_scene(const render::VisualDesc& desc, const render::Quality& quality);

  xr::Instance& runtime() { return *runtime_; }
  vulkan::Device& gpu() { return *gpu_; }
  render::Renderer& renderer() { return *renderer_; }
  ui::Window* window() { return window_.get(); }  // null: there is no display
  // Shows in the window what the left eye sees; nothing where there is none.
  std::optional<Error> mirror();

  // What Vulkan's validation layers have said so far, if options asked for them.
  std::vector<std::string> validation_messages() const { return instance_->messages(); }

private:
  HeadsetStage() = default;
  std::optional<Error> build(const std::string& title, const app::RunOptions& options);

  // In the order in which they need each other; destroyed backwards.
  std::unique_ptr<xr::Instance> runtime_;
  std::unique_ptr<ui::Window> window_;
  std::unique_ptr<vulkan::Instance> instance_;
  std::unique_ptr<vulkan::Surface> surface_;
  std::unique_ptr<vulkan::Device> gpu_;
  std::unique_ptr<vulkan::Swapchain> swapchain_;
  std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace fulcrum::headset
