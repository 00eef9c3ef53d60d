#pragma once
// Light that spreads below the surfaces of one view: what enters those that have a scatter distance, drawn
// for them alone, and what of it comes out again at each place, which their own shading then reads. Nothing
// else is drawn here, so that a tool before a gum hides none of the light within it; what lies beside the
// picture or on the far side sends none.

#include "engine/render/detailed_surfaces.h"
#include "engine/render/pipelines.h"
#include "engine/render/scene_geometry.h"
#include "engine/vulkan/buffer.h"
#include "engine/vulkan/descriptors.h"
#include "engine/vulkan/image.h"

namespace fulcrum::render {

class ScatterPass {
public:
  // A plan that has it. frame: the view's; distances: by an instance's number (scatter_taps.h). Throws
  // vulkan::Failure.
  ScatterPass(vulkan::Device& device, const RenderPlan& plan, VkBuffer frame, VkBuffer distances);

  // Of the descriptor set with the frame at 0, what enters at 1, distances at 2 and where to look at 3.
  VkDescriptorSetLayout layout() const { return set_.layout(); }
  // Irradiance / pi that enters, and radiance that does not spread; what comes out; each with its surface
  // (shaders/include/scatter_tag.glsl).
  VkImageView entering() const { return entering_.view(); }
  VkImageView spread() const { return spread_.view(); }
  VkSampler sampler() const { return sampler_.get(); }

  // Outside any rendering; scene_set: the view's.
  void record(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
              const DetailedSurfaces& detailed, VkDescriptorSet scene_set, const Sight& sight) const;

private:
  vulkan::SamplerHandle sampler_;
  vulkan::Buffer taps_;
  vulkan::Image depth_;
  vulkan::Image entering_;
  vulkan::Image spread_;
  vulkan::DescriptorSet set_;
};

}  // namespace fulcrum::render
