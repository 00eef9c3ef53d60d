#pragma once
// Draws a ghost: its surface in depth alone, its lines against that and against the scene, and the lines
// over the finished picture.

#include <memory>

#include "engine/render/frame_state.h"
#include "engine/render/ghost_edges.h"
#include "engine/render/pipelines.h"
#include "engine/render/scene_geometry.h"
#include "engine/vulkan/descriptors.h"
#include "engine/vulkan/image.h"

namespace fulcrum::render {

class GhostPass {
public:
  // Of one view. Views may share edges: one after the other chooses of them. Images and descriptors are for a
  // plan with a ghost and its targets. smooth: its lines are read with it, for a squeezed picture, too.
  // Throws vulkan::Failure.
  GhostPass(vulkan::Device& device, const Ghost& look, std::shared_ptr<GhostEdges> edges,
            const RenderPlan& plan, VkImageView scene_depth, VkSampler smooth);
  VkDescriptorSetLayout layout() const { return set_.layout(); }

  // What of the ghost is to be seen in the next frame, by that camera.
  void update(const GhostState& ghost, const Camera& camera, const RenderPlan& plan);
  bool shown() const { return draw_.colour.a > 0.0F; }

  // Outside any rendering, with the scene's depth ready to be sampled.
  void record_lines(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry);
  // Inside the rendering of the picture.
  void record_over(VkCommandBuffer commands, const Pipelines& pipelines) const;

private:
  void use(VkCommandBuffer commands, const Pipelines& pipelines, VkPipeline pipeline) const;

  Ghost look_;
  std::shared_ptr<GhostEdges> edges_;
  vulkan::Buffer chosen_;  // gpu::GhostLine
  std::uint32_t chosen_count_ = 0;
  gpu::GhostDraw draw_{};
  std::uint32_t layers_ = 1;  // of the camera

  vulkan::SamplerHandle sampler_;
  vulkan::Image depth_;
  vulkan::Image lines_;
  vulkan::DescriptorSet set_;
};

}  // namespace fulcrum::render
