#include "engine/vulkan/pipeline.h"

#include <array>

namespace fulcrum::vulkan {
namespace {

ShaderModuleHandle make_module(Device& device, std::span<const std::uint32_t> code) {
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  VkShaderModule module = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device.get(), &info, nullptr, &module), "load a shader");
  return {device.get(), module};
}

// Stages with what they point to, until the pipeline is made.
struct Stages {
  Stages(Device& device, const std::vector<Stage>& stages) {
    constants.reserve(stages.size());
    for (const Stage& stage : stages) {
      modules.push_back(make_module(device, stage.code));
      VkPipelineShaderStageCreateInfo info{};
      info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
      info.stage = stage.stage;
      info.module = modules.back().get();
      info.pName = "main";
      if (stage.constant) {
        constants.push_back({1, &entry, sizeof(std::uint32_t), &*stage.constant});
        info.pSpecializationInfo = &constants.back();
      }
      infos.push_back(info);
    }
  }
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  const VkSpecializationMapEntry entry{0, 0, sizeof(std::uint32_t)};
  std::vector<ShaderModuleHandle> modules;
  std::vector<VkSpecializationInfo> constants;
  std::vector<VkPipelineShaderStageCreateInfo> infos;
};

VkPipelineDepthStencilStateCreateInfo depth_state(const PipelineDesc& desc) {
  VkPipelineDepthStencilStateCreateInfo depth{};
  depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
  if (desc.depth_test) {
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = desc.depth_test->writes ? VK_TRUE : VK_FALSE;
    depth.depthCompareOp = desc.depth_test->passes;
  }
  return depth;
}

VkPipelineRasterizationStateCreateInfo raster_state(const PipelineDesc& desc) {
  VkPipelineRasterizationStateCreateInfo raster{};
  raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.cullMode = desc.cull.value_or(VK_CULL_MODE_NONE);
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.depthBiasEnable = desc.depth_bias != 0.0F ? VK_TRUE : VK_FALSE;
  raster.depthBiasConstantFactor = desc.depth_bias;
  raster.depthBiasSlopeFactor = desc.depth_bias;
  raster.lineWidth = 1.0F;
  return raster;
}

VkPipelineColorBlendAttachmentState blend_state(Blend blend) {
  VkPipelineColorBlendAttachmentState state{};
  state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                         VK_COLOR_COMPONENT_A_BIT;
  if (blend == Blend::over || blend == Blend::over_each) {
    state.blendEnable = VK_TRUE;
    state.srcColorBlendFactor = VK_BLEND_FACTOR_ONE;
    state.dstColorBlendFactor = blend == Blend::over_each ? VK_BLEND_FACTOR_ONE_MINUS_SRC1_COLOR
                                                          : VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    state.colorBlendOp = VK_BLEND_OP_ADD;
    state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    state.alphaBlendOp = VK_BLEND_OP_ADD;
  } else if (blend == Blend::largest) {
    state.blendEnable = VK_TRUE;
    state.colorBlendOp = VK_BLEND_OP_MAX;
    state.alphaBlendOp = VK_BLEND_OP_MAX;
  }
  return state;
}

}  // namespace

PipelineHandle make_pipeline(Device& device, const PipelineDesc& desc) {
  const Stages stages(device, desc.stages);
  const std::array<VkVertexInputBindingDescription, 2> buffers = {
      {{0, desc.vertex_stride, VK_VERTEX_INPUT_RATE_VERTEX},
       {1, desc.second_stride, VK_VERTEX_INPUT_RATE_VERTEX}}};
  VkPipelineVertexInputStateCreateInfo input{};
  input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  input.vertexBindingDescriptionCount = desc.vertex_stride == 0 ? 0 : desc.second_stride == 0 ? 1 : 2;
  input.pVertexBindingDescriptions = buffers.data();
  input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(desc.attributes.size());
  input.pVertexAttributeDescriptions = desc.attributes.data();

  VkPipelineInputAssemblyStateCreateInfo assembly{};
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;

  VkPipelineViewportStateCreateInfo viewport{};
  viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;

  const VkPipelineRasterizationStateCreateInfo raster = raster_state(desc);
  VkPipelineMultisampleStateCreateInfo samples{};
  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = desc.samples;
  samples.alphaToCoverageEnable = desc.alpha_is_coverage ? VK_TRUE : VK_FALSE;

  const VkPipelineDepthStencilStateCreateInfo depth = depth_state(desc);
  const VkPipelineColorBlendAttachmentState attachment = blend_state(desc.blend);
  const bool has_colour = desc.colour != VK_FORMAT_UNDEFINED;
  VkPipelineColorBlendStateCreateInfo blend{};
  blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  blend.attachmentCount = has_colour ? 1 : 0;
  blend.pAttachments = &attachment;

  std::vector<VkDynamicState> changing = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  if (desc.depth_test && desc.depth_test->compare_is_dynamic)
    changing.push_back(VK_DYNAMIC_STATE_DEPTH_COMPARE_OP);
  if (!desc.cull) changing.push_back(VK_DYNAMIC_STATE_CULL_MODE);
  VkPipelineDynamicStateCreateInfo dynamic{};
  dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  dynamic.dynamicStateCount = static_cast<std::uint32_t>(changing.size());
  dynamic.pDynamicStates = changing.data();

  VkPipelineRenderingCreateInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
  rendering.colorAttachmentCount = has_colour ? 1 : 0;
  rendering.pColorAttachmentFormats = &desc.colour;
  rendering.depthAttachmentFormat = desc.depth;

  VkGraphicsPipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.pNext = &rendering;
  info.stageCount = static_cast<std::uint32_t>(stages.infos.size());
  info.pStages = stages.infos.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = desc.layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
        "make a pipeline");
  return {device.get(), pipeline};
}

PipelineLayoutHandle make_pipeline_layout(Device& device, std::span<const VkDescriptorSetLayout> sets,
                                          std::span<const VkPushConstantRange> constants) {
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = static_cast<std::uint32_t>(constants.size());
  info.pPushConstantRanges = constants.data();
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device.get(), &info, nullptr, &layout), "lay out a pipeline");
  return {device.get(), layout};
}

}  // namespace fulcrum::vulkan
