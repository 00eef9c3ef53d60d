#pragma once
// Graphics pipelines for dynamic rendering. Viewport and scissor are always dynamic.

#include <optional>
#include <span>
#include <vector>

#include "engine/vulkan/device.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::vulkan {

// SPIR-V of one stage; entry point main.
struct Stage {
  VkShaderStageFlagBits stage = VK_SHADER_STAGE_VERTEX_BIT;
  std::span<const std::uint32_t> code;
  std::optional<std::uint32_t> constant{};  // the value of its specialisation constant 0
};

enum class Blend {
  none,
  over,       // what comes in is premultiplied by its alpha
  over_each,  // the same, but a second colour says how much each colour hides: needs Device::blends_by_two()
  largest     // of each component, whatever the order
};

struct DepthTest {
  VkCompareOp passes = VK_COMPARE_OP_GREATER;
  bool writes = true;
  bool compare_is_dynamic = false;  // set by vkCmdSetDepthCompareOp
};

struct PipelineDesc {
  std::vector<Stage> stages;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  std::uint32_t vertex_stride = 0;  // bytes; 0: the shader makes its vertices from gl_VertexIndex
  std::uint32_t second_stride = 0;  // the same of a second vertex buffer, binding 1
  std::vector<VkVertexInputAttributeDescription> attributes;
  VkFormat colour = VK_FORMAT_UNDEFINED;  // undefined: no colour target
  VkFormat depth = VK_FORMAT_UNDEFINED;   // undefined: no depth target
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  std::optional<VkCullModeFlags> cull = VK_CULL_MODE_NONE;  // none: set by vkCmdSetCullMode
  std::optional<DepthTest> depth_test;
  float depth_bias = 0.0F;  // constant, and the same again times the slope
  Blend blend = Blend::none;
  bool alpha_is_coverage = false;  // as many samples of a pixel are drawn as its alpha says
};

// Both throw Failure.
PipelineHandle make_pipeline(Device& device, const PipelineDesc& desc);
PipelineLayoutHandle make_pipeline_layout(Device& device, std::span<const VkDescriptorSetLayout> sets,
                                          std::span<const VkPushConstantRange> constants);

}  // namespace fulcrum::vulkan
