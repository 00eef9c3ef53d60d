#pragma once
// Ambient occlusion of one view: what it sees in depth alone, at half its size, and from that how much of the
// light from all around reaches each place. What the depth image does not hold hides nothing: what lies
// beside the picture or behind something else.

#include "engine/render/detailed_surfaces.h"
#include "engine/render/pipelines.h"
#include "engine/render/scene_geometry.h"
#include "engine/vulkan/descriptors.h"
#include "engine/vulkan/image.h"

namespace fulcrum::render {

class OcclusionPass {
public:
  // frame: the view's. Throws vulkan::Failure.
  OcclusionPass(vulkan::Device& device, Extent scene, VkBuffer frame);

  // Of the descriptor set with the frame at 0, depth at 1 and what is not smoothed yet at 2.
  VkDescriptorSetLayout layout() const { return set_.layout(); }
  // How much light is let through, and the distance that this is for.
  VkImageView view() const { return smooth_.view(); }
  VkSampler sampler() const { return sampler_.get(); }

  // Outside any rendering; scene_set: the view's. detailed: null without detailed surfaces.
  void record(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
              const DetailedSurfaces* detailed, VkDescriptorSet scene_set, const Sight& sight) const;

private:
  void record_depth(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
                    const DetailedSurfaces* detailed, VkDescriptorSet scene_set, const Sight& sight) const;
  void record_fullscreen(VkCommandBuffer commands, const Pipelines& pipelines, VkPipeline pipeline,
                         const vulkan::Image& to) const;

  vulkan::SamplerHandle sampler_;
  vulkan::Image depth_;
  vulkan::Image rough_;
  vulkan::Image smooth_;
  vulkan::DescriptorSet set_;
};

// Of a scene drawn at that size.
Extent occlusion_extent(Extent scene);

}  // namespace fulcrum::render
