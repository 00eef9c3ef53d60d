#include "engine/render/pipelines.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/render/look.h"
#include "engine/render/targets.h"
#include "engine/render/vertex.h"
#include "shaders/shared/ghost.h"
#include "shaders/shared/material.h"

namespace fulcrum::render {
namespace {

using vulkan::PipelineDesc;
using vulkan::PipelineHandle;

std::vector<vulkan::Stage> stages(const ShaderLibrary& shaders, const char* vertex, const char* fragment) {
  std::vector<vulkan::Stage> made = {{VK_SHADER_STAGE_VERTEX_BIT, shaders.code(vertex)}};
  if (fragment != nullptr) made.push_back({VK_SHADER_STAGE_FRAGMENT_BIT, shaders.code(fragment)});
  return made;
}

PipelineDesc scene_desc(const RenderPlan& plan, VkPipelineLayout layout) {
  PipelineDesc desc;
  desc.layout = layout;
  desc.colour = kSceneFormat;
  desc.depth = kDepthFormat;
  desc.samples = sample_count(plan);
  return desc;
}

void read_vertices(PipelineDesc& desc, bool shaded) {
  desc.vertex_stride = sizeof(Vertex);
  desc.attributes = {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)}};
  if (shaded) {
    desc.attributes.push_back({1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)});
    desc.attributes.push_back({2, 0, VK_FORMAT_R16G16B16A16_UNORM, offsetof(Vertex, colour)});
  }
}

// The name of the fragment shader that knows what the plan has.
std::string lit_as_planned(std::string name, const RenderPlan& plan) {
  if (plan.soft_shadows)
    name += "_softly_shadowed";
  else if (plan.shadow_size > 0)
    name += "_shadowed";
  if (plan.occlusion) name += "_occluded";
  if (plan.lights > 0) name += "_lamplit";
  return name;
}

// A surface's specialisation constant.
std::uint32_t planned(std::uint32_t look, const RenderPlan& plan) {
  return look | (plan.reflections ? FULCRUM_LOOK_NEIGHBOURS : 0U) | plan.lights << FULCRUM_LOOK_LIGHTS_SHIFT;
}

PipelineHandle make_surfaces(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                             VkPipelineLayout layout) {
  PipelineDesc desc = scene_desc(plan, layout);
  desc.stages = stages(shaders, "surface.vert", (lit_as_planned("surface", plan) + ".frag").c_str());
  desc.stages.back().constant = planned(0, plan);
  read_vertices(desc, true);
  desc.cull = VK_CULL_MODE_BACK_BIT;
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_GREATER, true, false};
  return make_pipeline(device, desc);
}

void read_uv(PipelineDesc& desc) {
  desc.second_stride = sizeof(glm::vec4);
  desc.attributes.push_back({3, 1, VK_FORMAT_R32G32B32A32_SFLOAT, 0});
}

const char* vertex_shader_of(std::uint32_t look) {
  return reads_places(look) ? "detailed.vert" : "detailed_without_places.vert";
}

// What a look has not is left out of its shader when that is compiled.
PipelineHandle make_detailed(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                             VkPipelineLayout layout, std::uint32_t look) {
  PipelineDesc desc = scene_desc(plan, layout);
  const std::string fragment = plan.scattering > 0 && is_scattering(look)
                                   ? "detailed_scattered.frag"
                                   : lit_as_planned("detailed", plan) + ".frag";
  desc.stages = stages(shaders, vertex_shader_of(look), fragment.c_str());
  desc.stages.back().constant = planned(look, plan);
  read_vertices(desc, true);
  if (reads_places(look)) read_uv(desc);
  desc.cull.reset();
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_GREATER, !is_blended(look), false};
  if (is_blended(look))
    desc.blend =
        lets_light_through(look) && device.blends_by_two() ? vulkan::Blend::over_each : vulkan::Blend::over;
  desc.alpha_is_coverage = is_masked(look) && desc.samples != VK_SAMPLE_COUNT_1_BIT;
  if (desc.alpha_is_coverage) *desc.stages.back().constant |= FULCRUM_LOOK_SAMPLES;
  return make_pipeline(device, desc);
}

PipelineDesc shadow_desc(VkPipelineLayout layout) {
  PipelineDesc desc;
  desc.layout = layout;
  read_vertices(desc, false);
  desc.depth = kDepthFormat;
  desc.cull.reset();
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_LESS, true, false};
  desc.depth_bias = 1.5F;
  return desc;
}

PipelineHandle make_shadow(vulkan::Device& device, const ShaderLibrary& shaders, VkPipelineLayout layout) {
  PipelineDesc desc = shadow_desc(layout);
  desc.stages = stages(shaders, "shadow.vert", nullptr);
  return make_pipeline(device, desc);
}

PipelineHandle make_masked_shadow(vulkan::Device& device, const ShaderLibrary& shaders,
                                  VkPipelineLayout layout) {
  PipelineDesc desc = shadow_desc(layout);
  desc.stages = stages(shaders, "masked_shadow.vert", "masked_shadow.frag");
  read_uv(desc);
  return make_pipeline(device, desc);
}

PipelineHandle make_occluders(vulkan::Device& device, const ShaderLibrary& shaders, VkPipelineLayout layout,
                              bool masked) {
  PipelineDesc desc;
  desc.layout = layout;
  read_vertices(desc, false);
  if (masked) read_uv(desc);
  desc.stages = masked ? stages(shaders, "masked_occluder.vert", "masked_shadow.frag")
                       : stages(shaders, "occluder.vert", nullptr);
  desc.depth = kDepthFormat;
  desc.cull.reset();
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_GREATER, true, false};
  return make_pipeline(device, desc);
}

void add_occlusion(Pipelines& made, vulkan::Device& device, const RenderPlan& plan,
                   const ShaderLibrary& shaders, VkDescriptorSetLayout set) {
  made.occluders = make_occluders(device, shaders, made.scene_layout.get(), false);
  if (std::ranges::any_of(plan.looks, is_masked))
    made.masked_occluders = make_occluders(device, shaders, made.detailed_layout.get(), true);
  made.occlusion_layout = vulkan::make_pipeline_layout(device, {&set, 1}, {});
  PipelineDesc found;
  found.layout = made.occlusion_layout.get();
  found.stages = stages(shaders, "screen.vert", "occlusion.frag");
  found.colour = kOcclusionFormat;
  made.occlusion = make_pipeline(device, found);
  found.stages = stages(shaders, "screen.vert", "occlusion_smooth.frag");
  made.occlusion_smooth = make_pipeline(device, found);
}

// One sample a pixel: what it draws is spread over many.
PipelineHandle make_entering(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                             VkPipelineLayout layout, std::uint32_t look) {
  PipelineDesc desc;
  desc.layout = layout;
  desc.colour = kEnteringFormat;
  desc.depth = kDepthFormat;
  desc.stages =
      stages(shaders, vertex_shader_of(look), (lit_as_planned("detailed", plan) + "_entering.frag").c_str());
  desc.stages.back().constant = planned(look, plan);
  read_vertices(desc, true);
  if (reads_places(look)) read_uv(desc);
  desc.cull.reset();
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_GREATER, true, false};
  return make_pipeline(device, desc);
}

void add_scattering(Pipelines& made, vulkan::Device& device, const RenderPlan& plan,
                    const ShaderLibrary& shaders, VkDescriptorSetLayout set) {
  for (const std::uint32_t look : plan.looks)
    if (is_scattering(look))
      made.entering[look] = make_entering(device, plan, shaders, made.detailed_layout.get(), look);
  made.scatter_layout = vulkan::make_pipeline_layout(device, {&set, 1}, {});
  PipelineDesc spread;
  spread.layout = made.scatter_layout.get();
  spread.stages = stages(shaders, "screen.vert", "scatter.frag");
  spread.stages.back().constant = static_cast<std::uint32_t>(plan.scattering);
  spread.colour = kSpreadFormat;
  made.scatter = make_pipeline(device, spread);
}

// Behind everything: it passes where nothing has been drawn, so hidden parts of it cost nothing.
PipelineHandle make_background(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                               VkPipelineLayout layout) {
  PipelineDesc desc = scene_desc(plan, layout);
  desc.stages =
      stages(shaders, "screen.vert", plan.seen_around ? "background_around.frag" : "background.frag");
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_EQUAL, false, false};
  return make_pipeline(device, desc);
}

PipelineHandle make_markers(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                            VkPipelineLayout layout) {
  PipelineDesc desc = scene_desc(plan, layout);
  desc.stages = stages(shaders, "marker.vert", "marker.frag");
  desc.depth_test = vulkan::DepthTest{VK_COMPARE_OP_GREATER, false, true};
  desc.blend = vulkan::Blend::over;
  return make_pipeline(device, desc);
}

void add_ghosts(Pipelines& made, vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                VkDescriptorSetLayout set) {
  const std::array<VkPushConstantRange, 1> draw = {{{kGhostStages, 0, sizeof(gpu::GhostDraw)}}};
  made.ghost_layout = vulkan::make_pipeline_layout(device, {&set, 1}, draw);
  PipelineDesc depth;
  depth.layout = made.ghost_layout.get();
  depth.stages = stages(shaders, "ghost_depth.vert", nullptr);
  read_vertices(depth, false);
  depth.depth = kDepthFormat;
  depth.cull = VK_CULL_MODE_BACK_BIT;
  depth.depth_test = vulkan::DepthTest{VK_COMPARE_OP_GREATER, true, false};
  made.ghost_depth = make_pipeline(device, depth);

  PipelineDesc lines;
  lines.layout = made.ghost_layout.get();
  lines.stages = stages(shaders, "ghost_line.vert",
                        plan.samples > 1 ? "ghost_line_multisampled.frag" : "ghost_line.frag");
  lines.colour = kGhostLineFormat;
  lines.blend = vulkan::Blend::largest;
  made.ghost_lines = make_pipeline(device, lines);

  PipelineDesc over;
  over.layout = made.ghost_layout.get();
  over.stages = stages(shaders, "screen.vert", "ghost_over.frag");
  over.colour = kPictureFormat;
  over.blend = vulkan::Blend::over;
  made.ghost_over = make_pipeline(device, over);
}

void add_stereo(Pipelines& made, vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                VkDescriptorSetLayout set) {
  constexpr std::array fragments{"stereo_halves.frag", "stereo_halves.frag", "stereo_interlaced.frag",
                                 "stereo_anaglyph.frag"};
  made.stereo_layout = vulkan::make_pipeline_layout(device, {&set, 1}, {});
  PipelineDesc stereo;
  stereo.layout = made.stereo_layout.get();
  stereo.stages = stages(shaders, "screen.vert", fragments[static_cast<std::size_t>(*plan.stereo)]);
  stereo.stages.back().constant = plan.screen_layer ? 1 : 0;
  stereo.colour = kPictureFormat;
  made.stereo = make_pipeline(device, stereo);
}

void add_enlargement(Pipelines& made, vulkan::Device& device, const ShaderLibrary& shaders) {
  PipelineDesc desc;
  desc.layout = made.tone_layout.get();
  desc.stages = stages(shaders, "screen.vert", "enlarge.frag");
  desc.colour = kPictureFormat;
  desc.stages.back().constant = 0;
  made.widen = make_pipeline(device, desc);
  desc.stages.back().constant = 1;
  made.heighten = make_pipeline(device, desc);
}

}  // namespace

Pipelines make_pipelines(vulkan::Device& device, const RenderPlan& plan, const ShaderLibrary& shaders,
                         const SetLayouts& sets) {
  const std::array<VkPushConstantRange, 1> visibility = {{{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(float)}}};
  Pipelines made;
  const auto pushed = plan.markers ? std::span(visibility) : std::span<const VkPushConstantRange>();
  made.scene_layout = vulkan::make_pipeline_layout(device, {&sets.scene, 1}, pushed);
  made.tone_layout = vulkan::make_pipeline_layout(device, {&sets.tone, 1}, {});
  const VkPipelineLayout layout = made.scene_layout.get();
  made.background = make_background(device, plan, shaders, layout);
  if (plan.plain_surfaces) made.surfaces = make_surfaces(device, plan, shaders, layout);
  if (plan.shadow_size > 0) made.shadow = make_shadow(device, shaders, layout);
  if (!plan.looks.empty()) {
    const std::array<VkDescriptorSetLayout, 2> both = {sets.scene, sets.material};
    made.detailed_layout = vulkan::make_pipeline_layout(device, both, pushed);
    for (const std::uint32_t look : plan.looks)
      made.detailed[look] = make_detailed(device, plan, shaders, made.detailed_layout.get(), look);
    if (plan.shadow_size > 0 && std::ranges::any_of(plan.looks, is_masked))
      made.masked_shadow = make_masked_shadow(device, shaders, made.detailed_layout.get());
  }
  if (plan.occlusion) add_occlusion(made, device, plan, shaders, sets.occlusion);
  if (plan.scattering > 0) add_scattering(made, device, plan, shaders, sets.scatter);
  if (plan.markers) made.markers = make_markers(device, plan, shaders, layout);
  if (plan.ghosts) add_ghosts(made, device, plan, shaders, sets.ghost);
  if (plan.stereo) add_stereo(made, device, plan, shaders, sets.stereo);
  PipelineDesc tone;
  tone.layout = made.tone_layout.get();
  tone.stages = stages(shaders, "screen.vert", "tone.frag");
  tone.colour = kPictureFormat;
  made.tone = make_pipeline(device, tone);
  if (plan.enlarged()) add_enlargement(made, device, shaders);
  return made;
}

}  // namespace fulcrum::render
