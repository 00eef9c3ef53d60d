#include "engine/render/renderer.h"

#include <atomic>
#include <cstdio>
#include <utility>

#include "engine/render/scatter_taps.h"
#include "engine/render/surroundings.h"

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

vulkan::SamplerHandle make_environment_sampler(vulkan::Device& device) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;  // between two roughnesses
  info.maxLod = VK_LOD_CLAMP_NONE;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  return vulkan::make_sampler(device, info);
}

// compared: it gives four comparisons' mean, else depth. Beyond the map nothing throws a shadow.
vulkan::SamplerHandle make_shadow_sampler(vulkan::Device& device, bool compared) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = info.minFilter = compared ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
  info.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
  info.compareEnable = compared ? VK_TRUE : VK_FALSE;
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
      setting_{desc.key_light, {}, desc.background},
      lights_(desc),
      markers_(desc.markers),
      shaders_(std::move(shaders)),
      commands_(device),
      scene_sampler_(make_scene_sampler(device)) {
  shared_.scene_sampler = scene_sampler_.get();
  if (!desc.instances.empty()) {
    geometry_ = std::make_unique<SceneGeometry>(device, desc);
    shared_.instances = geometry_->instances();
    build_environment(desc);
  }
  if (!facts_.looks.empty()) detailed_ = std::make_unique<DetailedSurfaces>(device, desc);
  if (facts_.scattering > 0) distances_ = scatter_distances(desc);
  take_ghosts(desc);
  if (!markers_.empty()) {
    marker_buffer_ = vulkan::Buffer(device, markers_.size() * sizeof(gpu::MarkerData),
                                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Place::upload);
    shared_.markers = marker_buffer_.get();
  }
}

Renderer::~Renderer() {
  vkDeviceWaitIdle(device_.get());
}

void Renderer::build_environment(const VisualDesc& desc) {
  const Surroundings around = surroundings_of(desc.ambient);
  const Environment made = make_environment(around);
  setting_.around = made.irradiance;
  for (const std::uint32_t layers : light_volume_layers(desc)) {
    const LightVolume light = make_light_volume(desc, layers, around, made.irradiance);
    volumes_.emplace_back(device_, layers, light);
    if (facts_.mirrored > 0)
      volumes_.back().mirror(device_, make_mirror_volume(desc, layers, light, made.irradiance));
  }
  shared_.volumes = volumes_;
  environment_ = vulkan::upload_texture(device_, VK_FORMAT_R16G16B16A16_SFLOAT,
                                        {kEnvironmentSize, kEnvironmentSize}, made.levels);
  environment_sampler_ = make_environment_sampler(device_);
  shared_.environment = environment_.view();
  shared_.environment_sampler = environment_sampler_.get();
}

void Renderer::take_ghosts(const VisualDesc& desc) {
  shared_.ghosts.clear();
  if (facts_.ghost_edges.empty()) return;
  for (const Ghost& look : desc.ghosts)
    shared_.ghosts.push_back({look, std::make_shared<GhostEdges>(desc, look)});
}

void Renderer::build(const RenderPlan& plan) {
  const bool first = generation_ == 0;
  const bool other_shadow = first || !ready_ || plan.shadow_size != plan_.shadow_size;
  const bool other_pipelines =
      first || !ready_ || plan.samples != plan_.samples || plan.ghosts != plan_.ghosts ||
      plan.occlusion != plan_.occlusion || plan.scattering != plan_.scattering ||
      plan.soft_shadows != plan_.soft_shadows || plan.reflections != plan_.reflections ||
      (plan.enlarged() && !plan_.enlarged()) || (plan.shadow_size > 0) != (plan_.shadow_size > 0);
  ready_ = false;
  drawn_ = false;
  plan_ = plan;
  main_ = {};  // the old ones go before the new ones come: both might not fit
  inset_.reset();
  stereo_.reset();
  picture_ = {};
  picture_ = make_picture(device_, plan);
  generation_ = next_generation();
  if (detailed_) detailed_->follow_slants(!plan.enlarged());  // what is enlarged is not so sharp anyway
  if (other_shadow) build_shadow_map();
  build_scatter_distances();
  main_ = View(device_, plan, shared_);
  if (plan.stereo) stereo_.emplace(device_, plan, shared_);
  if (plan.inset) inset_.emplace(device_, inset_plan(plan), shared_);
  if (other_pipelines)  // not for another size alone: drivers take long to compile them
    build_pipelines();
  ready_ = true;
}

void Renderer::build_scatter_distances() {
  if ((plan_.scattering > 0) == (shared_.scatter_distances != VK_NULL_HANDLE)) return;
  scatter_distances_ = {};
  if (plan_.scattering > 0)
    scatter_distances_ =
        vulkan::upload(device_, std::as_bytes(std::span(distances_)), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  shared_.scatter_distances = scatter_distances_.get();
}

void Renderer::build_pipelines() {
  // Of all ghosts alike.
  const VkDescriptorSetLayout ghost = main_.ghosts.empty() ? VK_NULL_HANDLE : main_.ghosts.front()->layout();
  const VkDescriptorSetLayout occlusion = main_.occlusion ? main_.occlusion->layout() : VK_NULL_HANDLE;
  const VkDescriptorSetLayout scatter = main_.scatter ? main_.scatter->layout() : VK_NULL_HANDLE;
  const VkDescriptorSetLayout stereo = stereo_ ? stereo_->set.layout() : VK_NULL_HANDLE;
  pipelines_ = make_pipelines(device_, plan_, shaders_,
                              {main_.scene_set.layout(), detailed_ ? detailed_->layout() : VK_NULL_HANDLE,
                               main_.tone_set.layout(), occlusion, scatter, ghost, stereo});
}

void Renderer::build_shadow_map() {
  shadow_map_ = {};
  standing_map_ = {};
  shared_.shadow_map = VK_NULL_HANDLE;
  if (plan_.shadow_size == 0) return;
  shadow_map_ = make_shadow_map(device_, plan_);
  if (plan_.standing_shadows) standing_map_ = make_shadow_map(device_, plan_);
  shadow_sampler_ = make_shadow_sampler(device_, true);
  shadow_depth_sampler_ = make_shadow_sampler(device_, false);
  shadow_stale_ = standing_stale_ = true;
  light_ = {};
  shared_.shadow_map = shadow_map_.view();
  shared_.shadow_sampler = shadow_sampler_.get();
  shared_.shadow_depth_sampler = shadow_depth_sampler_.get();
}

std::optional<Error> Renderer::rebuild(const RenderOptions& options) {
  const Result<RenderPlan> planned = render::plan(facts_, options);
  if (!planned) return planned.error();
  short_of_memory_ = false;
  try {
    build(*planned);
  } catch (const vulkan::Failure& failure) {
    short_of_memory_ = failure.is_of_memory();
    return Error{failure.what()};
  }
  options_ = options;
  return {};
}

std::optional<Error> Renderer::resize(Extent extent) {
  RenderOptions options = options_;
  options.extent = extent;
  options.inset.reset();  // until the next frame says where in the new picture it is
  return rebuild(options);
}

std::optional<Error> Renderer::set_quality(const Quality& quality) {
  RenderOptions options = options_;
  options.quality = quality;
  return rebuild(options);
}

std::optional<Error> Renderer::set_ghosts(const VisualDesc& desc) {
  const Result<RenderPlan> planned = render::plan(desc, options_);
  if (!planned) return planned.error();
  try {
    facts_ = facts_of(desc);
    take_ghosts(desc);
    build(*planned);
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
  return {};
}

std::optional<Error> Renderer::fit(Extent extent, const std::optional<Inset>& inset) {
  RenderOptions options = options_;
  options.extent = extent;
  options.inset.reset();
  if (inset) options.inset = Extent{inset->width, inset->height};
  if (options.extent == options_.extent && options.inset == options_.inset) return {};
  return rebuild(options);
}

void Renderer::reload_shaders() {
  const Result<bool> changed = shaders_.refresh();
  if (!changed) {
    std::fprintf(stderr, "%s\nThe shaders in use stay as they were.\n", changed.error().sentence.c_str());
  } else if (*changed) {
    build_pipelines();
    shadow_stale_ = standing_stale_ = true;
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
  if (!state.ghosts.empty() && state.ghosts.size() != shared_.ghosts.size()) {
    return Error{"A frame came with " + std::to_string(state.ghosts.size()) + " ghosts, but the scene has " +
                 std::to_string(shared_.ghosts.size()) + "; give one for each, or none."};
  }
  if (state.inset && (state.inset->x + state.inset->width > plan_.picture.width ||
                      state.inset->y + state.inset->height > plan_.picture.height))
    return Error{"A frame came with a second view that reaches beyond the picture; lay it inside."};
  if (state.overlay != nullptr && stereo_ && !plan_.screen_layer)
    return Error{
        "A frame came with panels, but its picture for two eyes has nothing at the screen; leave them out."};
  if (geometry_ && geometry_->place(state.X_WM)) shadow_stale_ = true;
  if (std::exchange(layers_, state.camera.layers) != state.camera.layers) {
    shadow_stale_ = standing_stale_ = true;
    light_ = {};
  }
  if (plan_.shadow_size > 0 && shadow_stale_) fit_shadow();
  inset_at_ = state.inset;
  fit_inset_shadow();
  const auto show = [&](View& view, const Camera& camera, const LightFit& light) {
    FrameState seen = state;
    seen.camera = camera;
    view.light_by(device_, shared_, volume_for(volumes_, camera.layers));
    gpu::FrameData data =
        frame_data(setting_, seen, view.plan.picture, view.plan.scene, light, plan_.shadow_size);
    if (!volumes_.empty()) write_volume(volumes_[view.volume], data);
    view.update(data, seen);
  };
  if (stereo_) {
    show(main_, state.eyes ? state.eyes->front() : seen_by(Eye::left, *options_.stereo, state.camera),
         light_);
    show(stereo_->right,
         state.eyes ? state.eyes->back() : seen_by(Eye::right, *options_.stereo, state.camera), light_);
  } else {
    show(main_, state.camera, light_);
  }
  if (inset_) show(*inset_, state.inset->camera, inset_light_.value_or(light_));
  place_lights(state.X_WM);
  markers_shown_ = plan_.markers ? write_markers(markers_, state.markers, state.marker_colours,
                                                 reinterpret_cast<gpu::MarkerData*>(marker_buffer_.mapped()))
                                 : 0;
  return {};
}

void Renderer::fit_shadow() {
  const std::vector<Bounds> casters = geometry_->casters(layers_);
  if (casters.empty()) {
    light_ = {};
    return;
  }
  const bool fitted = light_.texel > 0.0F;
  if (fitted && standing_map_ && still_fits(light_, *setting_.key_light, casters, plan_.shadow_size)) return;
  light_ = fit_light(*setting_.key_light, casters, plan_.shadow_size);
  standing_stale_ = true;
}

void Renderer::fit_inset_shadow() {
  inset_light_.reset();
  if (!inset_at_ || plan_.shadow_size == 0 || !geometry_) return;
  const std::uint32_t layers = inset_at_->camera.layers;
  if (geometry_->casts_alike(layers_, layers)) return;
  const std::vector<Bounds> casters = geometry_->casters(layers);
  inset_light_ = casters.empty() ? LightFit() : fit_light(*setting_.key_light, casters, plan_.shadow_size);
}

void Renderer::place_lights(std::span<const glm::mat4> X_WM) {
  main_.light_by(lights_, X_WM);
  if (stereo_) stereo_->right.light_by(lights_, X_WM);
  if (inset_) inset_->light_by(lights_, X_WM);
}

std::function<void()> Renderer::placing(const LatePoses& late) {
  if (!late || !geometry_) return {};
  return [this, &late] {
    const std::span<const glm::mat4> X_WM = late();
    if (X_WM.size() != geometry_->movable_count())
      throw vulkan::Failure("A frame was told " + std::to_string(X_WM.size()) +
                            " poses late, but the scene has " + std::to_string(geometry_->movable_count()) +
                            " movable instances; give one pose for each.");
    // The shadow of this frame may have been kept from the one before: the next one is drawn for certain.
    if (geometry_->place(X_WM)) shadow_stale_ = true;
    place_lights(X_WM);
  };
}

std::optional<Error> Renderer::frame(const FrameState& state, const TakePicture& take,
                                     const LatePoses& late) {
  if (auto error = fit(options_.extent, state.inset)) return *error;
  try {
    reload_shaders();
    if (auto error = update(state)) return *error;
    const auto record_and_take = [&](VkCommandBuffer commands) {
      record(commands, state.overlay);
      if (take) take(commands, picture_);
    };
    commands_.run(record_and_take, {}, placing(late));
    last_frame_s_ = commands_.last_run_s();
    drawn_ = true;
    return {};
  } catch (const vulkan::Failure& failure) {
    shadow_stale_ = standing_stale_ = true;  // what was recorded of them was not drawn
    return Error{failure.what()};
  }
}

Result<bool> Renderer::frame(const FrameState& state, vulkan::Swapchain& window, Extent size,
                             const LatePoses& late) {
  if (size.width == 0 || size.height == 0) return false;
  if (auto error = fit(size, state.inset)) return *error;
  try {
    reload_shaders();
    if (auto error = update(state)) return *error;
    const VkExtent2D extent{size.width, size.height};
    const auto record_all = [&](VkCommandBuffer commands) { record(commands, state.overlay); };
    const bool shown =
        window.show(commands_, extent, picture_.get(), picture_.extent(), record_all, placing(late));
    if (shown) {
      last_frame_s_ = commands_.last_run_s();
      drawn_ = true;
    }
    return shown;
  } catch (const vulkan::Failure& failure) {
    shadow_stale_ = standing_stale_ = true;  // what was recorded of them was not drawn
    return Error{failure.what()};
  }
}

std::optional<Error> Renderer::show_again(vulkan::Swapchain& window, Extent size, Extent part) {
  if (!drawn_) return {};
  try {
    window.show(commands_, {size.width, size.height}, picture_.get(), {part.width, part.height},
                [](VkCommandBuffer) {});
    return {};
  } catch (const vulkan::Failure& failure) {
    return Error{failure.what()};
  }
}

Result<Picture> Renderer::read_back() {
  if (!drawn_) return Error{"There is no picture yet: draw a frame before reading it back."};
  const VkExtent2D extent = picture_.extent();
  Picture picture{extent.width, extent.height, {}};
  try {
    const std::size_t bytes = std::size_t{extent.width} * extent.height * 4;
    const vulkan::Buffer buffer(device_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::Place::readback);
    commands_.run([&](VkCommandBuffer commands) {
      VkBufferImageCopy copy{};
      copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
      copy.imageExtent = {extent.width, extent.height, 1};
      vkCmdCopyImageToBuffer(commands, picture_.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.get(), 1,
                             &copy);
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

std::optional<Error> take_quality(Renderer& renderer, AutoQuality& choice) {
  for (;;) {
    std::optional<Error> error = renderer.set_quality(choice.quality());
    if (!error || !renderer.is_short_of_memory() || !choice.refuse()) return error;
    std::fprintf(stderr,
                 "Graphics memory is short for this quality of the picture: it is lower from here on.\n");
  }
}

}  // namespace fulcrum::render
