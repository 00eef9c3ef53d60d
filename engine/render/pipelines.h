#pragma once
// The pipelines of a plan: those that it names and no other.

#include "engine/render/plan.h"
#include "engine/render/shader_library.h"
#include "engine/vulkan/pipeline.h"

namespace fulcrum::render {

// Bindings of the one descriptor set of the scene passes.
constexpr std::uint32_t kFrameBinding = 0;
constexpr std::uint32_t kInstancesBinding = 1;
constexpr std::uint32_t kMarkersBinding = 2;
constexpr std::uint32_t kShadowBinding = 3;

struct Pipelines {
  vulkan::PipelineLayoutHandle scene_layout;
  vulkan::PipelineLayoutHandle tone_layout;
  vulkan::PipelineHandle background;
  vulkan::PipelineHandle tone;
  vulkan::PipelineHandle surfaces;  // this and the next two: empty unless planned
  vulkan::PipelineHandle shadow;
  vulkan::PipelineHandle markers;
};

/// Throws vulkan::Failure.
Pipelines make_pipelines(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                         VkDescriptorSetLayout scene_set, VkDescriptorSetLayout tone_set);

}  // namespace fulcrum::render
