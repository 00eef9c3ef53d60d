#include "engine/render/renderer.h"

#include <atomic>
#include <cstdio>
#include <cstring>

namespace fulcrum::render {
namespace {

// No two of any renderers are alike: an overlay may be shown by one and then by another.
std::uint64_t next_generation() {
  static std::atomic<std::uint64_t> newest{0};
  return ++newest;
}

vulkan::SamplerHandle make_scene_sampler(vulkan::Device& device) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  return vulkan::make_sampler(device, info);
}

vulkan::SamplerHandle make_shadow_sampler(vulkan::Device& device) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = VK_FILTER_LINEAR;  // of four comparisons
  info.minFilter = VK_FILTER_LINEAR;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.compareEnable = VK_TRUE;
  info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  return vulkan::make_sampler(device, info);
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(vulkan::Device& device, const VisualDesc& desc,
                                                   const RenderOptions& options) {
  const Result<RenderPlan> planned = render::plan(desc, options);
  if (!planned) return planned.error();
  Result<ShaderLibrary> shaders = ShaderLibrary::open(options.shader_folder);
  if (!shaders) return shaders.error();
  try {
    std::unique_ptr<Renderer> made(new Renderer(device, desc, options, std::move(*shaders)));
    made->build(*planned);
    return made;
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
}

Renderer::Renderer(vulkan::Device& device, const VisualDesc& desc, const RenderOptions& options,
                   ShaderLibrary shaders)
    : device_(device),
      options_(options),
      facts_(facts_of(desc)),
      setting_{desc.key_light, desc.ambient, desc.background},
      markers_(desc.markers),
      shaders_(std::move(shaders)),
      commands_(device),
      frame_buffer_(device, sizeof(gpu::FrameData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                    vulkan::Place::upload),
      scene_sampler_(make_scene_sampler(device)) {
  if (!desc.instances.empty()) geometry_ = std::make_unique<SceneGeometry>(device, desc);
  if (facts_.ghost_edges > 0) ghost_ = std::make_unique<GhostPass>(device, desc);
  if (!markers_.empty()) {
    marker_buffer_ = vulkan::Buffer(device, markers_.size() * sizeof(gpu::MarkerData),
                                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Place::upload);
  }
}

Renderer::~Renderer() {
  vkDeviceWaitIdle(device_.get());
}

void Renderer::build(const RenderPlan& plan) {
  const bool first = generation_ == 0;
  const bool other_shadow = first || !ready_ || plan.shadow_size != plan_.shadow_size;
  const bool other_pipelines =
      first || !ready_ || plan.samples != plan_.samples || (plan.shadow_size > 0) != (plan_.shadow_size > 0);
  ready_ = false;
  drawn_ = false;
  plan_ = plan;
  targets_ = {};  // the old ones go before the new ones come: both might not fit
  targets_ = make_targets(device_, plan);
  generation_ = next_generation();
  tone_set_ = vulkan::DescriptorSet(
      device_, {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE,
                 targets_.scene.view(), scene_sampler_.get()}});
  if (other_shadow) build_scene_set();
  if (ghost_) ghost_->build(plan, targets_.depth.view());
  if (other_pipelines)  // not for another size alone: drivers take long to compile them
    build_pipelines();
  ready_ = true;
}

void Renderer::build_pipelines() {
  const VkDescriptorSetLayout ghost = ghost_ ? ghost_->layout() : VK_NULL_HANDLE;
  pipelines_ = make_pipelines(device_, plan_, shaders_, {scene_set_.layout(), tone_set_.layout(), ghost});
}

void Renderer::build_scene_set() {
  constexpr VkShaderStageFlags both = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  std::vector<vulkan::Binding> bindings = {
      {kFrameBinding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, both, frame_buffer_.get()}};
  if (plan_.surfaces) {
    bindings.push_back({kInstancesBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT,
                        geometry_->instances()});
  }
  if (plan_.markers) {
    bindings.push_back({kMarkersBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT,
                        marker_buffer_.get()});
  }
  shadow_map_ = {};
  if (plan_.shadow_size > 0) {
    shadow_map_ = make_shadow_map(device_, plan_);
    shadow_sampler_ = make_shadow_sampler(device_);
    shadow_stale_ = true;
    bindings.push_back({kShadowBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                        VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, shadow_map_.view(),
                        shadow_sampler_.get()});
  }
  scene_set_ = vulkan::DescriptorSet(device_, bindings);
}

std::optional<Error> Renderer::rebuild(const RenderOptions& options) {
  const Result<RenderPlan> planned = render::plan(facts_, options);
  if (!planned) return planned.error();
  try {
    build(*planned);
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
  options_ = options;
  return {};
}

std::optional<Error> Renderer::resize(Extent extent) {
  RenderOptions options = options_;
  options.extent = extent;
  return rebuild(options);
}

std::optional<Error> Renderer::set_quality(const Quality& quality) {
  RenderOptions options = options_;
  options.quality = quality;
  return rebuild(options);
}

void Renderer::reload_shaders() {
  const Result<bool> changed = shaders_.refresh();
  if (!changed) {
    std::fprintf(stderr, "%s\nThe shaders in use stay as they were.\n", changed.error().sentence.c_str());
  } else if (*changed) {
    build_pipelines();
    shadow_stale_ = true;
  }
}

std::optional<Error> Renderer::update(const FrameState& state) {
  if (!ready_) {
    return Error{
        "The renderer could not be built for its last size or quality; choose a smaller one before drawing."};
  }
  const std::size_t movable = geometry_ ? geometry_->movable_count() : 0;
  if (state.X_WM.size() != movable) {
    return Error{"A frame came with " + std::to_string(state.X_WM.size()) + " poses, but the scene has " +
                 std::to_string(movable) + " movable instances; give one pose for each."};
  }
  if (!state.markers.empty() && state.markers.size() != markers_.size()) {
    return Error{"A frame came with " + std::to_string(state.markers.size()) +
                 " marker states, but the scene has " + std::to_string(markers_.size()) +
                 " markers; give one for each, or none."};
  }
  if (state.ghost.opacity > 0.0F && !ghost_)
    return Error{"A frame came with a ghost, but the scene has none; name it in the scene."};
  if (geometry_ && geometry_->place(state.X_WM)) shadow_stale_ = true;
  if (geometry_ && geometry_->see(state.camera.layers)) shadow_stale_ = true;
  if (plan_.shadow_size > 0 && shadow_stale_) {
    const std::vector<Bounds> casters = geometry_->casters();
    light_ = casters.empty() ? LightFit{} : fit_light(*setting_.key_light, casters, plan_.shadow_size);
  }
  const gpu::FrameData data = frame_data(setting_, state, plan_.scene, light_, plan_.shadow_size);
  std::memcpy(frame_buffer_.mapped(), &data, sizeof(data));
  if (ghost_) ghost_->update(state, plan_);
  markers_shown_ = plan_.markers ? write_markers(markers_, state.markers,
                                                 reinterpret_cast<gpu::MarkerData*>(marker_buffer_.mapped()))
                                 : 0;
  return {};
}

std::optional<Error> Renderer::frame(const FrameState& state) {
  try {
    reload_shaders();
    if (auto error = update(state)) return *error;
    commands_.run([&](VkCommandBuffer commands) { record(commands, state.overlay); });
    last_frame_s_ = commands_.last_run_s();
    drawn_ = true;
    return {};
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
}

Result<bool> Renderer::frame(const FrameState& state, vulkan::Swapchain& window, Extent size) {
  if (size.width == 0 || size.height == 0) return false;
  if (!(size == options_.extent)) {
    if (auto error = resize(size)) return *error;
  }
  try {
    reload_shaders();
    if (auto error = update(state)) return *error;
    const VkExtent2D extent{size.width, size.height};
    const bool shown = window.show(commands_, extent, targets_.picture.get(), targets_.picture.extent(),
                                   [&](VkCommandBuffer commands) { record(commands, state.overlay); });
    if (shown) {
      last_frame_s_ = commands_.last_run_s();
      drawn_ = true;
    }
    return shown;
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
}

Result<Picture> Renderer::read_back() {
  if (!drawn_) return Error{"There is no picture yet: draw a frame before reading it back."};
  const VkExtent2D extent = targets_.picture.extent();
  Picture picture{extent.width, extent.height, {}};
  try {
    const std::size_t bytes = std::size_t{extent.width} * extent.height * 4;
    const vulkan::Buffer buffer(device_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::Place::readback);
    commands_.run([&](VkCommandBuffer commands) {
      VkBufferImageCopy copy{};
      copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
      copy.imageExtent = {extent.width, extent.height, 1};
      vkCmdCopyImageToBuffer(commands, targets_.picture.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                             buffer.get(), 1, &copy);
      VkMemoryBarrier2 to_host{};
      to_host.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
      to_host.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
      to_host.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
      to_host.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
      to_host.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
      VkDependencyInfo dependency{};
      dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
      dependency.memoryBarrierCount = 1;
      dependency.pMemoryBarriers = &to_host;
      vkCmdPipelineBarrier2(commands, &dependency);
    });
    const auto* start = reinterpret_cast<const std::uint8_t*>(buffer.mapped());
    picture.rgba.assign(start, start + bytes);
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
  return picture;
}

}  // namespace fulcrum::render
