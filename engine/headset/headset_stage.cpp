#include "engine/headset/headset_stage.h"

#include <cstdio>
#include <utility>

#include "drivers/registry.h"

namespace fulcrum::headset {
namespace {

render::Extent side_by_side(VkExtent2D eye) {
  return {2 * eye.width, eye.height};
}

}  // namespace

Result<std::unique_ptr<HeadsetStage>> HeadsetStage::create(const std::string& title,
                                                           const app::RunOptions& options) {
  std::unique_ptr<HeadsetStage> self(new HeadsetStage);
  try {
    if (auto error = self->build(title, options)) return *error;
  } catch (const xr::Failure& failure) {
    return Error{failure.what()};
  }
  return self;
}

std::optional<Error> HeadsetStage::build(const std::string& title, const app::RunOptions& options) {
  auto runtime = xr::Instance::create(tracks_hands(options.device));
  if (!runtime) return runtime.error();
  runtime_ = std::move(*runtime);
  vulkan::InstanceOptions instance_options;
  instance_options.validation = options.validate;
  instance_options.creator = runtime_.get();
  const VkExtent2D eye = runtime_->recommended_eye();
  if (ui::why_no_window().empty()) {
    const std::uint32_t height = options.size.height;
    auto window = ui::Window::create(title, {height * eye.width / eye.height, height});
    if (!window) return window.error();
    window_ = std::move(*window);
    instance_options.extensions = window_->instance_extensions();
  }
  auto instance = vulkan::Instance::create(instance_options);
  if (!instance) return instance.error();
  instance_ = std::make_unique<vulkan::Instance>(std::move(*instance));
  if (window_) {
    auto surface = window_->surface(*instance_);
    if (!surface) return surface.error();
    surface_ = std::make_unique<vulkan::Surface>(std::move(*surface));
  }
  auto gpu =
      vulkan::Device::create(*instance_, "", surface_ ? surface_->get() : VK_NULL_HANDLE, runtime_.get());
  if (!gpu) return gpu.error();
  gpu_ = std::move(*gpu);
  if (window_) {
    auto swapchain = vulkan::Swapchain::create(*gpu_, surface_->get(), vulkan::Pace::free);
    if (!swapchain) return swapchain.error();
    swapchain_ = std::move(*swapchain);
    window_->show();
  }
  std::fprintf(stderr, "Headset: %s, by %s, %u x %u for each eye.\n", runtime_->headset().c_str(),
               runtime_->runtime().c_str(), eye.width, eye.height);
  return std::nullopt;
}

std::optional<Error> HeadsetStage::set_scene(const render::VisualDesc& desc, const render::Quality& quality) {
  render::RenderOptions options;
  try {
    options.extent = side_by_side(runtime_->recommended_eye());
  } catch (const xr::Failure& failure) {
    return Error{failure.what()};
  }
  options.quality = quality;
  options.stereo = render::Stereo{render::StereoMode::side_by_side};
  options.at_screen = false;  // panels are the runtime's to show
  options.shader_folder = render::development_shader_folder();
  auto renderer = render::Renderer::create(*gpu_, desc, options);
  if (!renderer) return renderer.error();
  renderer_ = std::move(*renderer);
  return std::nullopt;
}

std::optional<Error> HeadsetStage::mirror() {
  if (!window_) return std::nullopt;
  return renderer_->show_again(*swapchain_, window_->pixels(), renderer_->plan().eye);
}

}  // namespace fulcrum::headset
