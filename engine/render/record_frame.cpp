// How a frame is recorded: shadow map, then scene and ghosts of each view, tone mapping, overlay.

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/render/recording.h"
#include "engine/render/renderer.h"

namespace fulcrum::render {
namespace {

vulkan::ImageUse either(const vulkan::ImageUse& a, const vulkan::ImageUse& b) {
  return {a.stage | b.stage, a.access | b.access, VK_IMAGE_LAYOUT_UNDEFINED};
}

// Of the shadow map: half of one of its texels is seen no more than half a pixel is. A spot's texels widen
// with the distance along its axis, which is at least the distance from the lamp times the cosine of half its
// cone.
Sight sight_of(const LightFit& light, const KeyLight& key, float coarseness, std::uint32_t layers) {
  constexpr float kTexels = 0.5F;
  const float may_be_off = coarseness > 0.0F ? kTexels * light.texel : 0.0F;
  if (key.kind == KeyLight::Kind::directional)
    return {light.clip_from_world, glm::vec3(0.0F), 0.0F, may_be_off, layers};
  return {light.clip_from_world, key.position, may_be_off * std::cos(0.5F * key.cone_rad), 0.0F, layers};
}

}  // namespace

void Renderer::record(VkCommandBuffer commands, OverlayPass* overlay) {
  namespace use = vulkan::use;
  if (plan_.shadow_size > 0 && shadow_stale_) {
    record_shadow(commands);
    shadow_stale_ = false;
  }
  record_view(commands, main_);
  if (stereo_) record_view(commands, stereo_->right);
  if (inset_light_) record_inset_shadow(commands);
  if (inset_) record_view(commands, *inset_);
  if (stereo_) {
    record_stereo(commands, overlay);
  } else {
    record_picture(commands);
    if (overlay != nullptr) overlay->record(commands, {picture_.view(), picture_.extent(), generation_});
  }
  vulkan::barrier(commands, picture_.get(), kColour, use::kColourTarget, use::kCopySource);
}

// Up to its scene and lines, which are then ready to be laid into the picture.
void Renderer::record_view(VkCommandBuffer commands, View& view) {
  namespace use = vulkan::use;
  const bool ghosts =
      std::any_of(view.ghosts.begin(), view.ghosts.end(), [](const auto& each) { return each->shown(); });
  if (view.occlusion)
    view.occlusion->record(commands, pipelines_, *geometry_, detailed_.get(), view.scene_set.get(),
                           view.sight);
  if (view.scatter)
    view.scatter->record(commands, pipelines_, *geometry_, *detailed_, view.scene_set.get(), view.sight);
  record_scene(commands, view, ghosts);
  if (ghosts) vulkan::barrier(commands, view.targets.depth.get(), kDepth, use::kDepthTarget, use::kSampled);
  for (const auto& ghost : view.ghosts)
    if (ghost->shown()) ghost->record_lines(commands, pipelines_, *geometry_);
  vulkan::barrier(commands, view.targets.scene.get(), kColour, use::kColourTarget, use::kSampled);
  if (view.plan.enlarged()) record_finished(commands, view);
}

// Tone mapped while it has few pixels, and as wide as it is shown.
void Renderer::record_finished(VkCommandBuffer commands, const View& view) {
  namespace use = vulkan::use;
  const auto draw = [&](const vulkan::Image& to, VkPipeline pipeline, VkDescriptorSet set) {
    vulkan::barrier(commands, to.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
    const VkRenderingAttachmentInfo colour =
        attachment(to.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                   VK_ATTACHMENT_STORE_OP_STORE);
    begin(commands, to.extent(), &colour, nullptr);
    bind(commands, pipeline, pipelines_.tone_layout.get(), set);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
    vulkan::barrier(commands, to.get(), kColour, use::kColourTarget, use::kSampled);
  };
  draw(view.targets.finished, pipelines_.tone.get(), view.tone_set.get());
  draw(view.targets.widened, pipelines_.widen.get(), view.widen_set.get());
}

// Where something stands and something else moves, the map begins as a copy of what stands.
void Renderer::record_shadow(VkCommandBuffer commands) {
  namespace use = vulkan::use;
  using Casters = SceneGeometry::Casters;
  if (standing_map_) {
    if (standing_stale_) record_standing_shadow(commands);
    vulkan::barrier(commands, shadow_map_.get(), kDepth, discarded_after(use::kSampled), use::kCopyTarget);
    VkImageCopy all{};
    all.srcSubresource = all.dstSubresource = {kDepth, 0, 0, 1};
    all.extent = {shadow_map_.extent().width, shadow_map_.extent().height, 1};
    vkCmdCopyImage(commands, standing_map_.get(), use::kCopySource.layout, shadow_map_.get(),
                   use::kCopyTarget.layout, 1, &all);
    vulkan::barrier(commands, shadow_map_.get(), kDepth, use::kCopyTarget, use::kDepthTarget);
    draw_shadows(commands, shadow_map_, Casters::moving, main_, light_);
  } else {
    vulkan::barrier(commands, shadow_map_.get(), kDepth, discarded_after(use::kSampled), use::kDepthTarget);
    draw_shadows(commands, shadow_map_, Casters::all, main_, light_);
  }
  vulkan::barrier(commands, shadow_map_.get(), kDepth, use::kDepthTarget, use::kSampled);
}

void Renderer::record_standing_shadow(VkCommandBuffer commands) {
  namespace use = vulkan::use;
  vulkan::barrier(commands, standing_map_.get(), kDepth, discarded_after(use::kCopySource),
                  use::kDepthTarget);
  draw_shadows(commands, standing_map_, SceneGeometry::Casters::standing, main_, light_);
  vulkan::barrier(commands, standing_map_.get(), kDepth, use::kDepthTarget, use::kCopySource);
  standing_stale_ = false;
}

// In the place of the main view's, which has been drawn, and whose map is drawn anew in the next frame.
void Renderer::record_inset_shadow(VkCommandBuffer commands) {
  namespace use = vulkan::use;
  vulkan::barrier(commands, shadow_map_.get(), kDepth, discarded_after(use::kSampled), use::kDepthTarget);
  draw_shadows(commands, shadow_map_, SceneGeometry::Casters::all, *inset_, *inset_light_);
  vulkan::barrier(commands, shadow_map_.get(), kDepth, use::kDepthTarget, use::kSampled);
  shadow_stale_ = true;
}

// Into what is there already where that is what moves, else into an empty map.
void Renderer::draw_shadows(VkCommandBuffer commands, const vulkan::Image& map, SceneGeometry::Casters which,
                            const View& view, const LightFit& fit) {
  const bool kept = which == SceneGeometry::Casters::moving;
  VkRenderingAttachmentInfo depth = attachment(
      map.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
      kept ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_STORE);
  depth.clearValue.depthStencil.depth = 1.0F;
  begin(commands, map.extent(), nullptr, &depth);
  if (fit.texel > 0.0F) {  // else nothing is to be seen from there
    bind(commands, pipelines_.shadow.get(), pipelines_.scene_layout.get(), view.scene_set.get());
    const Sight light = sight_of(fit, *setting_.key_light, plan_.coarseness, view.sight.layers);
    geometry_->draw_casters(commands, which, light);
    if (detailed_)
      detailed_->record_shadows(commands, pipelines_, *geometry_, view.scene_set.get(), which, light);
  }
  vkCmdEndRendering(commands);
}

void Renderer::record_scene(VkCommandBuffer commands, const View& view, bool ghosts) {
  namespace use = vulkan::use;
  const Targets& targets = view.targets;
  const bool resolves = static_cast<bool>(targets.samples);
  const vulkan::Image& drawn = resolves ? targets.samples : targets.scene;
  vulkan::barrier(commands, targets.scene.get(), kColour, discarded_after(use::kSampled), use::kColourTarget);
  if (resolves)
    vulkan::barrier(commands, drawn.get(), kColour, discarded_after(use::kColourTarget), use::kColourTarget);
  vulkan::barrier(commands, targets.depth.get(), kDepth,
                  discarded_after(either(use::kDepthTarget, use::kSampled)), use::kDepthTarget);

  // Every pixel is drawn, by the background if by nothing else: no clear.
  VkRenderingAttachmentInfo colour =
      attachment(drawn.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 resolves ? VK_ATTACHMENT_STORE_OP_DONT_CARE : VK_ATTACHMENT_STORE_OP_STORE);
  if (resolves) {
    colour.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    colour.resolveImageView = targets.scene.view();
    colour.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  }
  VkRenderingAttachmentInfo depth =
      attachment(targets.depth.view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR,
                 ghosts ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE);
  depth.clearValue.depthStencil.depth = 0.0F;  // reversed: infinitely far
  begin(commands, targets.scene.extent(), &colour, &depth);
  if (geometry_) record_opaque(commands, view);
  bind(commands, pipelines_.background.get(), pipelines_.scene_layout.get(), view.scene_set.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  if (detailed_)
    detailed_->record_blended(commands, pipelines_, *geometry_, view.scene_set.get(), view.sight);
  if (markers_shown_ > 0) record_markers(commands);
  vkCmdEndRendering(commands);
}

void Renderer::record_opaque(VkCommandBuffer commands, const View& view) {
  geometry_->bind(commands);
  const SceneGeometry::Piece* bound = nullptr;
  const std::vector<SceneGeometry::Draw> draws = geometry_->opaque(view.sight);
  for (const SceneGeometry::Draw& draw : draws) {
    const SceneGeometry::Piece* before = std::exchange(bound, &draw.of);
    if (bound->material)
      detailed_->bind(commands, pipelines_, *bound, before, view.scene_set.get());
    else if (before == nullptr || before->material)
      bind(commands, pipelines_.surfaces.get(), pipelines_.scene_layout.get(), view.scene_set.get());
    geometry_->draw(commands, draw);
  }
}

void Renderer::record_markers(VkCommandBuffer commands) {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.markers.get());
  const auto draw = [&](VkCompareOp passes, float visibility) {
    vkCmdSetDepthCompareOp(commands, passes);
    vkCmdPushConstants(commands, pipelines_.scene_layout.get(), VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(visibility), &visibility);
    vkCmdDraw(commands, 6, markers_shown_, 0, 0);
  };
  draw(VK_COMPARE_OP_GREATER, 1.0F);
  draw(VK_COMPARE_OP_LESS_OR_EQUAL, 0.22F);  // behind something: a trainee must still find the way
}

void Renderer::record_picture(VkCommandBuffer commands) {
  namespace use = vulkan::use;
  vulkan::barrier(commands, picture_.get(), kColour, discarded_after(use::kCopySource), use::kColourTarget);
  const VkRenderingAttachmentInfo colour =
      attachment(picture_.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                 VK_ATTACHMENT_STORE_OP_STORE);
  begin(commands, picture_.extent(), &colour, nullptr);
  record_tone(commands, main_);
  if (inset_) record_inset(commands);
  vkCmdEndRendering(commands);
}

void Renderer::record_inset(VkCommandBuffer commands) {
  set_area(commands, inset_at_->x, inset_at_->y, {inset_at_->width, inset_at_->height});
  record_tone(commands, *inset_);
}

// Into the part of the picture that the view fills.
void Renderer::record_tone(VkCommandBuffer commands, const View& view) {
  const bool enlarged = view.plan.enlarged();
  bind(commands, enlarged ? pipelines_.heighten.get() : pipelines_.tone.get(), pipelines_.tone_layout.get(),
       enlarged ? view.heighten_set.get() : view.tone_set.get());
  vkCmdDraw(commands, 3, 1, 0, 0);
  for (const auto& ghost : view.ghosts)
    if (ghost->shown()) ghost->record_over(commands, pipelines_);
}

}  // namespace fulcrum::render
