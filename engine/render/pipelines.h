#pragma once
// The pipelines of a plan: those that it names and no other.

#include <map>

#include "engine/render/plan.h"
#include "engine/render/shader_library.h"
#include "engine/vulkan/pipeline.h"

namespace fulcrum::render {

// Bindings of the one descriptor set of the scene passes.
constexpr std::uint32_t kFrameBinding = 0;
constexpr std::uint32_t kInstancesBinding = 1;
constexpr std::uint32_t kMarkersBinding = 2;
constexpr std::uint32_t kShadowBinding = 3;
constexpr std::uint32_t kEnvironmentBinding = 4;
constexpr std::uint32_t kOcclusionBinding = 5;
constexpr std::uint32_t kOpenBinding = 6;
constexpr std::uint32_t kReceivedBinding = 7;
constexpr std::uint32_t kSentOnBinding = 8;
constexpr std::uint32_t kShadowDepthBinding = 9;
constexpr std::uint32_t kLightsBinding = 10;
constexpr std::uint32_t kScatteredBinding = 11;
constexpr std::uint32_t kEnteringBinding = 12;
constexpr std::uint32_t kMirroredBinding = 13;
constexpr std::uint32_t kMirroredSidesBinding = 14;

// Bindings of the ghost's descriptor set.
constexpr std::uint32_t kGhostChosenBinding = 0;
constexpr std::uint32_t kGhostDepthBinding = 1;
constexpr std::uint32_t kGhostSceneBinding = 2;
constexpr std::uint32_t kGhostLinesBinding = 3;
constexpr VkShaderStageFlags kGhostStages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;  // that read its push constants

struct Pipelines {
  vulkan::PipelineLayoutHandle scene_layout;
  vulkan::PipelineLayoutHandle tone_layout;
  vulkan::PipelineHandle background;
  vulkan::PipelineHandle tone;
  vulkan::PipelineHandle widen, heighten;  // this and what follows: empty unless planned
  vulkan::PipelineHandle surfaces;
  vulkan::PipelineLayoutHandle detailed_layout;
  std::map<std::uint32_t, vulkan::PipelineHandle> detailed;  // by look (look.h)
  vulkan::PipelineHandle masked_shadow;
  vulkan::PipelineHandle shadow;
  vulkan::PipelineLayoutHandle occlusion_layout;
  vulkan::PipelineHandle occluders;
  vulkan::PipelineHandle masked_occluders;
  vulkan::PipelineHandle occlusion;
  vulkan::PipelineHandle occlusion_smooth;
  std::map<std::uint32_t, vulkan::PipelineHandle> entering;  // by look, of those that light spreads below
  vulkan::PipelineLayoutHandle scatter_layout;
  vulkan::PipelineHandle scatter;
  vulkan::PipelineHandle markers;
  vulkan::PipelineLayoutHandle ghost_layout;
  vulkan::PipelineHandle ghost_depth;
  vulkan::PipelineHandle ghost_lines;
  vulkan::PipelineHandle ghost_over;
  vulkan::PipelineLayoutHandle stereo_layout;
  vulkan::PipelineHandle stereo;
};

struct SetLayouts {
  VkDescriptorSetLayout scene = VK_NULL_HANDLE;
  VkDescriptorSetLayout material = VK_NULL_HANDLE;  // read only if the plan has detailed surfaces
  VkDescriptorSetLayout tone = VK_NULL_HANDLE;
  VkDescriptorSetLayout occlusion = VK_NULL_HANDLE;  // read only if the plan has ambient occlusion
  VkDescriptorSetLayout scatter = VK_NULL_HANDLE;    // read only if the plan has subsurface scattering
  VkDescriptorSetLayout ghost = VK_NULL_HANDLE;      // read only if the plan has a ghost
  VkDescriptorSetLayout stereo = VK_NULL_HANDLE;     // read only if the plan is for two eyes
};

// Throws vulkan::Failure.
Pipelines make_pipelines(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                         const SetLayouts& sets);

}  // namespace fulcrum::render
