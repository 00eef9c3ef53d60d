#pragma once
// One camera's way from the scene to the picture: its images, its figures, its ghosts. The whole picture is
// one, a second view another, and in stereo a second eye.

#include <memory>
#include <span>
#include <vector>

#include "engine/render/ghost_pass.h"
#include "engine/render/occlusion_pass.h"
#include "engine/render/punctual_lights.h"
#include "engine/render/scatter_pass.h"
#include "engine/render/sight.h"
#include "engine/render/targets.h"
#include "engine/render/volume_on_device.h"
#include "engine/vulkan/buffer.h"
#include "engine/vulkan/descriptors.h"
#include "shaders/shared/frame.h"

namespace fulcrum::render {

struct SharedGhost {
  Ghost look;
  std::shared_ptr<GhostEdges> edges;
};

// What all views have in common. Null: the plan has no such thing.
struct SharedParts {
  VkBuffer instances = VK_NULL_HANDLE;
  VkBuffer markers = VK_NULL_HANDLE;
  VkBuffer scatter_distances = VK_NULL_HANDLE;
  VkImageView shadow_map = VK_NULL_HANDLE;
  VkSampler shadow_sampler = VK_NULL_HANDLE;
  VkSampler shadow_depth_sampler = VK_NULL_HANDLE;
  VkImageView environment = VK_NULL_HANDLE;
  VkSampler environment_sampler = VK_NULL_HANDLE;  // and of the volumes
  std::span<const VolumeOnDevice> volumes;         // none without instances
  VkSampler scene_sampler = VK_NULL_HANDLE;
  std::vector<SharedGhost> ghosts;
};

struct View {
  View() = default;
  // Throws vulkan::Failure.
  View(vulkan::Device& device, const RenderPlan& plan, const SharedParts& shared);

  // What hides light from what it sees: that volume of the shared ones. Not while a frame is in flight.
  void light_by(vulkan::Device& device, const SharedParts& shared, std::size_t which);
  // Of what the next frame shows; state: with this view's camera.
  void update(gpu::FrameData data, const FrameState& state);
  // Where the lights that models bring are, for its camera; nothing where the plan has none.
  void light_by(const PunctualLights& lights, std::span<const glm::mat4> X_WM);

  RenderPlan plan;  // its picture is the part of the picture that the view fills
  Targets targets;
  vulkan::Buffer frame_buffer;
  vulkan::Buffer lights;                   // beside the key light; empty: the plan has none
  std::optional<OcclusionPass> occlusion;  // where the plan has it
  std::optional<ScatterPass> scatter;      // where the plan has it
  std::size_t volume = 0;                  // of the shared ones
  vulkan::DescriptorSet scene_set;
  vulkan::DescriptorSet tone_set;
  vulkan::DescriptorSet widen_set, heighten_set;  // where the plan enlarges
  std::vector<std::unique_ptr<GhostPass>> ghosts;
  Sight sight;  // of its camera
};

// The plan of the second view that a plan has.
RenderPlan inset_plan(const RenderPlan& plan);

}  // namespace fulcrum::render
