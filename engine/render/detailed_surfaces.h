#pragma once
// The textures and numbers of detailed materials on the device, and how their surfaces are drawn.

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include "engine/render/pipelines.h"
#include "engine/render/scene_geometry.h"
#include "engine/vulkan/buffer.h"
#include "engine/vulkan/descriptors.h"
#include "engine/vulkan/image.h"

namespace fulcrum::render {

class DetailedSurfaces {
public:
  // A valid description with at least one detailed material that an instance shows. Throws vulkan::Failure.
  DetailedSurfaces(vulkan::Device& device, const VisualDesc& desc);

  // Of the second descriptor set, whose material's numbers are at 0 and whose textures follow in their order.
  VkDescriptorSetLayout layout() const { return layout_; }

  // Whether textures are sampled between two of their sizes, and along the slant where the device can: it
  // makes them smoother and sharper, and costs much without a graphics card. Not while a frame is being
  // drawn.
  void follow_slants(bool follow) { follows_slants_ = follow; }

  // Binds what a detailed piece is drawn with, and both of its sides where it has two; the geometry is bound
  // by the caller. before: the piece that was drawn last, plain or detailed; null: none.
  void bind(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry::Piece& piece,
            const SceneGeometry::Piece* before, VkDescriptorSet scene_set) const;
  // Draws the blended ones, the farthest first.
  void record_blended(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
                      VkDescriptorSet scene_set, const Sight& sight) const;
  // In depth alone, with their holes, those that are not blended.
  void record_occluders(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
                        VkDescriptorSet scene_set, const Sight& sight) const;
  // The light that enters those that it spreads below, with their numbers.
  void record_entering(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
                       VkDescriptorSet scene_set, const Sight& sight) const;
  // The shadows of those that have holes.
  void record_shadows(VkCommandBuffer commands, const Pipelines& pipelines, const SceneGeometry& geometry,
                      VkDescriptorSet scene_set, SceneGeometry::Casters which, const Sight& light) const;

private:
  struct OnDevice {
    vulkan::Buffer numbers;
    std::array<vulkan::DescriptorSet, 2> sets;  // not along the slant, along it
  };

  VkSampler sampler(vulkan::Device& device, Wrap wrap_u, Wrap wrap_v, bool nearest, bool along_slant);
  VkDescriptorSet set_of(const SceneGeometry::Piece& piece) const;
  OnDevice make(vulkan::Device& device, const VisualDesc& desc, const Material& material);

  vulkan::Image white_;                                 // stands where a material has no texture
  std::vector<std::optional<vulkan::Image>> textures_;  // by the description's; none: no instance shows it
  std::map<std::tuple<Wrap, Wrap, bool, bool>, vulkan::SamplerHandle> samplers_;
  bool follows_slants_ = true;
  std::vector<std::optional<OnDevice>> materials_;  // by the description's; none: it is plain, or not shown
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;   // of all of them alike
};

}  // namespace fulcrum::render
