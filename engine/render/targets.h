#pragma once
// The images that frames are drawn into: those of each view of the scene, and the picture.

#include "engine/render/overlay_pass.h"
#include "engine/render/plan.h"
#include "engine/vulkan/image.h"

namespace fulcrum::render {

constexpr VkFormat kSceneFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat kOcclusionFormat = VK_FORMAT_R16G16_SFLOAT;
constexpr VkFormat kEnteringFormat = VK_FORMAT_R32G32B32A32_UINT;  // shaders/include/scatter_tag.glsl
constexpr VkFormat kSpreadFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat kGhostLineFormat = VK_FORMAT_R8G8_UNORM;

struct Targets {
  vulkan::Image samples;  // empty with one sample a pixel
  vulkan::Image scene;
  vulkan::Image depth;
  vulkan::Image finished;  // the scene, tone mapped before it is enlarged; empty where it need not be
  vulkan::Image widened;   // the same, as wide as it is shown
};

inline VkSampleCountFlagBits sample_count(const RenderPlan& plan) {
  return plan.samples == 4 ? VK_SAMPLE_COUNT_4_BIT : VK_SAMPLE_COUNT_1_BIT;
}

// All throw vulkan::Failure where memory runs out.
Targets make_targets(vulkan::Device& device, const RenderPlan& plan);
vulkan::Image make_picture(vulkan::Device& device, const RenderPlan& plan);
vulkan::Image make_shadow_map(vulkan::Device& device, const RenderPlan& plan);

}  // namespace fulcrum::render
