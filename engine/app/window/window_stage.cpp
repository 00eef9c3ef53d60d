#include "engine/app/window/window_stage.h"

#include <utility>

#include "engine/app/cli/terminal.h"

namespace fulcrum::app {

Result<std::unique_ptr<WindowStage>> WindowStage::create(const std::string& title, const RunOptions& options,
                                                         const Settings& settings) {
  std::unique_ptr<WindowStage> self(new WindowStage);
  self->settings_ = settings;
  self->stereo_ = stereo_of(options.stereo);
  auto window = ui::Window::create(title, options.size);
  if (!window) return window.error();
  self->window_ = std::move(*window);
  vulkan::InstanceOptions instance_options;
  instance_options.extensions = self->window_->instance_extensions();
  instance_options.validation = options.validate;
  auto instance = vulkan::Instance::create(instance_options);
  if (!instance) return instance.error();
  self->instance_ = std::make_unique<vulkan::Instance>(std::move(*instance));
  auto surface = self->window_->surface(*self->instance_);
  if (!surface) return surface.error();
  self->surface_ = std::make_unique<vulkan::Surface>(std::move(*surface));
  auto gpu = vulkan::Device::create(*self->instance_, options.gpu, self->surface_->get());
  if (!gpu) return gpu.error();
  self->gpu_ = std::move(*gpu);
  auto swapchain = vulkan::Swapchain::create(*self->gpu_, self->surface_->get());
  if (!swapchain) return swapchain.error();
  self->swapchain_ = std::move(*swapchain);
  auto overlay = ui::Overlay::create(*self->gpu_);
  if (!overlay) return overlay.error();
  self->overlay_ = std::move(*overlay);
  // Of an empty scene, to draw cards with.
  render::RenderOptions empty;
  empty.extent = options.size;
  empty.quality = kCardQuality;
  empty.stereo = self->stereo_;
  auto renderer = render::Renderer::create(*self->gpu_, {}, empty);
  if (!renderer) return renderer.error();
  self->renderer_ = std::move(*renderer);
  // Once unseen: a driver compiles at the first frame, and an empty window is black until then.
  ui::OverlayState reading;
  reading.look = settings.look;
  reading.busy = {title, "Reading the scenario", 0, ""};
  if (auto error = self->overlay_->prepare(reading, options.size)) return *error;
  render::FrameState card;
  card.overlay = self->overlay_.get();
  if (auto error = self->renderer_->frame(card)) return *error;
  self->window_->show();
  if (auto shown = self->show(reading, {}); !shown) return shown.error();
  if (!self->overlay_->font_note().empty()) complain(self->overlay_->font_note());
  return self;
}

std::optional<Error> WindowStage::wait() {
  const render::Extent size = window_->pixels();
  try {
    swapchain_->wait({size.width, size.height});
    return std::nullopt;
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
}

Result<bool> WindowStage::show(const ui::Busy& busy) {
  ui::OverlayState state;
  state.look = settings_.look;
  state.busy = busy;
  return show(state, {});
}

Result<bool> WindowStage::show(const ui::OverlayState& state, render::FrameState frame) {
  window_->poll_or_wait();
  const render::Extent size = window_->pixels();
  if (size.width > 0 && size.height > 0) {
    if (auto error = overlay_->prepare(state, size)) return *error;
    frame.overlay = overlay_.get();
    if (const auto drawn = renderer_->frame(frame, *swapchain_, size); !drawn && !window_->lost())
      return drawn.error();
  }
  return !window_->closing();
}

std::optional<Error> WindowStage::set_scene(const render::VisualDesc& desc, const render::Quality& quality) {
  render::RenderOptions options;
  options.extent = renderer_->plan().picture;
  options.quality = quality;
  options.stereo = stereo_;
  options.shader_folder = render::development_shader_folder();
  auto renderer = render::Renderer::create(*gpu_, desc, options);
  if (!renderer) return renderer.error();
  renderer_ = std::move(*renderer);
  return std::nullopt;
}

}  // namespace fulcrum::app
