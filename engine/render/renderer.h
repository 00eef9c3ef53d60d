#pragma once
// Draws a scene: into a picture that can be read back, and from there into a window.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/render/detailed_surfaces.h"
#include "engine/render/frame_data.h"
#include "engine/render/overlay_pass.h"
#include "engine/render/picture.h"
#include "engine/render/pipelines.h"
#include "engine/render/punctual_lights.h"
#include "engine/render/scene_geometry.h"
#include "engine/render/stereo_targets.h"
#include "engine/render/view.h"
#include "engine/vulkan/commands.h"
#include "engine/vulkan/swapchain.h"

namespace fulcrum::render {

// Records what is done with a finished picture, which is in layout TRANSFER_SRC before and after.
using TakePicture = std::function<void(VkCommandBuffer, const vulkan::Image& picture)>;

// Tells the poses of the movable instances (FrameState::X_WM) once more, as late as it may be: once all is
// recorded and nothing is submitted. By then they are a picture's recording, and the wait for a window's
// picture, newer. What is culled, and how far shadows reach, is still by the poses of the frame's state.
using LatePoses = std::function<std::span<const glm::mat4>()>;

class Renderer {
public:
  // Plans, then builds the plan. The device must outlive the renderer; `desc` is not needed afterwards.
  static Result<std::unique_ptr<Renderer>> create(vulkan::Device& device, const VisualDesc& desc,
                                                  const RenderOptions& options);
  ~Renderer();

  const RenderPlan& plan() const { return plan_; }
  const Quality& quality() const { return options_.quality; }

  // Draws one frame into the picture and waits for it. Fails where the state does not fit the scene, or the
  // device is lost. take: who takes the picture elsewhere with the same submission; none: nobody.
  std::optional<Error> frame(const FrameState& state, const TakePicture& take = {},
                             const LatePoses& late = {});

  // The same, and shows it. The picture takes the window's size (pixels). False: the window is minimised or
  // changed this very moment, and nothing was drawn.
  Result<bool> frame(const FrameState& state, vulkan::Swapchain& window, Extent size,
                     const LatePoses& late = {});

  // Shows the upper left part of the last frame's picture in a window as well, enlarged or reduced to it;
  // part: pixels. Nothing where there is none yet, or where the window is minimised or changed this very
  // moment.
  std::optional<Error> show_again(vulkan::Swapchain& window, Extent size, Extent part);

  // How long the last frame took to record and draw, without waiting for the screen (s).
  double last_frame_s() const { return last_frame_s_; }
  // The same from its submission alone, which is when late poses are told.
  double last_submission_s() const { return commands_.last_submission_s(); }

  // How many the last frame's camera has seen, of each instance at the level that it was drawn at.
  std::uint64_t triangles() const { return geometry_ ? geometry_->triangles(main_.sight) : 0; }

  // The picture of the last frame.
  Result<Picture> read_back();

  std::optional<Error> resize(Extent extent);
  // What it was to be built as last failed for want of memory: it draws again once it is built as less.
  bool is_short_of_memory() const { return short_of_memory_; }
  std::optional<Error> set_quality(const Quality& quality);
  // From here on the scene has other ghosts: desc is the description that it was created from, with them.
  std::optional<Error> set_ghosts(const VisualDesc& desc);

private:
  Renderer(vulkan::Device& device, const VisualDesc& desc, const RenderOptions& options,
           ShaderLibrary shaders);

  std::optional<Error> rebuild(const RenderOptions& options);
  void build(const RenderPlan& plan);
  void build_environment(const VisualDesc& desc);
  void take_ghosts(const VisualDesc& desc);
  void build_shadow_map();
  void build_scatter_distances();
  void build_pipelines();
  void reload_shaders();
  // Builds anew where the picture or the second view is of another size, or comes or goes.
  std::optional<Error> fit(Extent extent, const std::optional<Inset>& inset);
  std::optional<Error> update(const FrameState& state);
  void fit_shadow();
  void fit_inset_shadow();
  // Of the lights that models bring, in all views.
  void place_lights(std::span<const glm::mat4> X_WM);
  // Of poses that are told late; null: there are none.
  std::function<void()> placing(const LatePoses& late);
  void record(VkCommandBuffer commands, OverlayPass* overlay);
  void record_shadow(VkCommandBuffer commands);
  void record_standing_shadow(VkCommandBuffer commands);
  void record_inset_shadow(VkCommandBuffer commands);
  // For that view, and what throws shadows there.
  void draw_shadows(VkCommandBuffer commands, const vulkan::Image& map, SceneGeometry::Casters which,
                    const View& view, const LightFit& light);
  void record_view(VkCommandBuffer commands, View& view);
  void record_scene(VkCommandBuffer commands, const View& view, bool ghosts);
  // The nearest first, whatever it is made of.
  void record_opaque(VkCommandBuffer commands, const View& view);
  void record_markers(VkCommandBuffer commands);
  void record_picture(VkCommandBuffer commands);
  void record_inset(VkCommandBuffer commands);
  void record_finished(VkCommandBuffer commands, const View& view);
  void record_tone(VkCommandBuffer commands, const View& view);
  void record_stereo(VkCommandBuffer commands, OverlayPass* overlay);
  void record_eye(VkCommandBuffer commands, const View& view, const vulkan::Image& finished);
  void record_screen(VkCommandBuffer commands, OverlayPass* overlay);

  vulkan::Device& device_;
  RenderOptions options_;
  SceneFacts facts_;
  Setting setting_;
  PunctualLights lights_;
  std::vector<Marker> markers_;
  RenderPlan plan_;
  bool short_of_memory_ = false;
  ShaderLibrary shaders_;
  vulkan::Commands commands_;

  std::unique_ptr<SceneGeometry> geometry_;     // null without instances
  std::unique_ptr<DetailedSurfaces> detailed_;  // null without detailed materials
  std::vector<glm::vec4> distances_;            // that light spreads to below surfaces, of each that it does
  vulkan::Buffer scatter_distances_;            // the same; empty where the plan has no such light
  vulkan::Buffer marker_buffer_;                // empty without markers
  vulkan::Image environment_;                   // this and the volumes: empty without instances
  std::vector<VolumeOnDevice> volumes_;
  vulkan::SamplerHandle environment_sampler_;
  vulkan::SamplerHandle shadow_sampler_;
  vulkan::SamplerHandle shadow_depth_sampler_;
  vulkan::SamplerHandle scene_sampler_;

  SharedParts shared_;
  vulkan::Image shadow_map_;    // empty without shadows
  vulkan::Image standing_map_;  // the same of what never moves; empty where the plan has none
  vulkan::Image picture_;
  View main_;                            // in stereo the left eye's
  std::optional<StereoTargets> stereo_;  // where the plan is for two eyes
  std::optional<View> inset_;            // where the plan has a second view
  std::optional<Inset> inset_at_;        // of the newest frame
  Pipelines pipelines_;
  std::uint64_t generation_ = 0;  // of the image that an overlay is drawn into

  std::uint32_t layers_ = 1;  // of the newest frame's camera
  LightFit light_;
  std::optional<LightFit> inset_light_;  // where other things throw shadows in the second view
  bool shadow_stale_ = true;
  bool standing_stale_ = true;
  std::uint32_t markers_shown_ = 0;
  bool ready_ = false;  // false when memory ran out while building for another size
  bool drawn_ = false;
  double last_frame_s_ = 0.0;
};

// Draws as choice has chosen from now on, or, where graphics memory is too short for that, which is said, at
// the best level below. An error: at none, or for another reason.
std::optional<Error> take_quality(Renderer& renderer, AutoQuality& choice);

}  // namespace fulcrum::render
