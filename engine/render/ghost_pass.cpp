#include "engine/render/ghost_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/render/frame_data.h"
#include "engine/render/recording.h"
#include "engine/render/targets.h"

namespace fulcrum::render {
namespace {

constexpr float kHaloReach = 1.6F;        // of a line's width
constexpr float kThinnest_pixels = 1.3F;  // in a small window a line must stay one

// IEC 61966-2-1.
float srgb_encoded(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

}  // namespace

GhostPass::GhostPass(vulkan::Device& device, const Ghost& look, std::shared_ptr<GhostEdges> edges,
                     const RenderPlan& plan, VkImageView scene_depth, VkSampler smooth)
    : look_(look),
      edges_(std::move(edges)),
      chosen_(device, edges_->size() * sizeof(gpu::GhostLine), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
              vulkan::Place::upload),
      sampler_(make_texel_sampler(device)) {
  const VkExtent2D extent{plan.picture.width, plan.picture.height};
  depth_ = vulkan::Image(device, {kDepthFormat, extent,
                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  lines_ = vulkan::Image(
      device, {kGhostLineFormat, extent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  const auto sampled = [](std::uint32_t number, VkImageView view, VkSampler sampler) {
    return vulkan::Binding{
        number, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE, view,
        sampler};
  };
  set_ = vulkan::DescriptorSet(device, {{kGhostChosenBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                         VK_SHADER_STAGE_VERTEX_BIT, chosen_.get()},
                                        sampled(kGhostDepthBinding, depth_.view(), sampler_.get()),
                                        sampled(kGhostSceneBinding, scene_depth, sampler_.get()),
                                        sampled(kGhostLinesBinding, lines_.view(), smooth)});
}

void GhostPass::update(const GhostState& ghost, const Camera& camera, const RenderPlan& plan) {
  const glm::vec3 colour = ghost.colour.value_or(look_.colour);
  draw_.colour = glm::vec4(srgb_encoded(colour.r), srgb_encoded(colour.g), srgb_encoded(colour.b),
                           std::clamp(ghost.opacity, 0.0F, 1.0F));
  layers_ = camera.layers;
  if (!shown()) return;
  const glm::vec4 p_GE = glm::inverse(ghost.X_WG) * glm::vec4(camera.eye, 1.0F);
  chosen_count_ = static_cast<std::uint32_t>(
      edges_->choose(glm::vec3(p_GE), reinterpret_cast<gpu::GhostLine*>(chosen_.mapped())));
  draw_.clip_from_ghost = clip_from_world(camera, plan.picture) * ghost.X_WG;
  const auto width = static_cast<float>(plan.picture.width);
  const auto height = static_cast<float>(plan.picture.height);
  draw_.size = {width, height, static_cast<float>(plan.scene.width) / width,
                static_cast<float>(plan.scene.height) / height};
  const float line = std::max(look_.line_width * height, kThinnest_pixels);
  draw_.width = {0.5F * line, kHaloReach * line, 0.0F, 0.0F};
}

void GhostPass::use(VkCommandBuffer commands, const Pipelines& pipelines, VkPipeline pipeline) const {
  bind(commands, pipeline, pipelines.ghost_layout.get(), set_.get());
  vkCmdPushConstants(commands, pipelines.ghost_layout.get(), kGhostStages, 0, sizeof(draw_), &draw_);
}

void GhostPass::record_lines(VkCommandBuffer commands, const Pipelines& pipelines,
                             const SceneGeometry& geometry) {
  namespace to = vulkan::use;
  vulkan::barrier(commands, depth_.get(), kDepth, discarded_after(to::kSampled), to::kDepthTarget);
  VkRenderingAttachmentInfo depth = attachment(depth_.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                               VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_STORE);
  depth.clearValue.depthStencil.depth = 0.0F;  // reversed: infinitely far
  begin(commands, depth_.extent(), nullptr, &depth);
  use(commands, pipelines, pipelines.ghost_depth.get());
  geometry.draw_tool(commands, layers_);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, depth_.get(), kDepth, to::kDepthTarget, to::kSampled);

  vulkan::barrier(commands, lines_.get(), kColour, discarded_after(to::kSampled), to::kColourTarget);
  const VkRenderingAttachmentInfo lines =
      attachment(lines_.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, lines_.extent(), &lines, nullptr);
  use(commands, pipelines, pipelines.ghost_lines.get());
  vkCmdDraw(commands, 6, chosen_count_, 0, 0);
  vkCmdEndRendering(commands);
  vulkan::barrier(commands, lines_.get(), kColour, to::kColourTarget, to::kSampled);
}

void GhostPass::record_over(VkCommandBuffer commands, const Pipelines& pipelines) const {
  use(commands, pipelines, pipelines.ghost_over.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
}

}  // namespace fulcrum::render
