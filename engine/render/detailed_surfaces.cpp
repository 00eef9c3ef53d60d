#include "engine/render/detailed_surfaces.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "engine/render/look.h"
#include "engine/render/mip_chain.h"
#include "engine/render/recording.h"
#include "engine/render/scatter_taps.h"
#include "shaders/shared/material.h"

namespace fulcrum::render {
namespace {

constexpr float kAnisotropy = 8.0F;  // samples along the slant, at most

vulkan::Image on_device(vulkan::Device& device, const Texture& texture, bool is_relief) {
  return vulkan::upload_texture(device, texture.srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                                {texture.width, texture.height},
                                is_relief ? relief_chain(texture) : mip_chain(texture));
}

// A texture of normals has no alpha that anything else would read.
std::vector<bool> reliefs(const VisualDesc& desc) {
  std::vector<bool> are(desc.textures.size(), false);
  for (const Material& material : desc.materials)
    if (material.detail)
      if (const auto& layer = material.detail->layers[SurfaceDetail::normal]) are[layer->texture] = true;
  return are;
}

// is_cut: its texture has been (mip_chain()), with the opacity that it is multiplied by.
gpu::MaterialData numbers_of(const SurfaceDetail& detail, bool is_cut) {
  gpu::MaterialData made{};
  made.emission =
      glm::vec4(detail.emission, is_cut ? kCutOff * std::max(detail.opacity, 1e-6F) : detail.alpha_cutoff);
  made.amounts = {detail.normal_scale, detail.occlusion_strength, detail.opacity, detail.transmission};
  made.specular = glm::vec4(detail.f0, detail.f90);
  made.coat = {detail.clearcoat, detail.clearcoat_roughness, 0.0F, detail.sheen_roughness};
  made.sheen = glm::vec4(detail.sheen, 0.0F);
  made.passed = glm::vec4(detail.passed, 0.0F);
  made.scattering = with_greatest(detail.scatter_distance);
  for (std::size_t i = 0; i < SurfaceDetail::kKinds; ++i) {
    const TextureLayer layer = detail.layers[i].value_or(TextureLayer{});
    made.uv_turn[i] = {layer.turn[0].x, layer.turn[1].x, layer.turn[0].y, layer.turn[1].y};
    made.uv_shift[i] = {layer.shift.x, layer.shift.y, layer.uv_set == 1 ? 1.0F : 0.0F, 0.0F};
  }
  return made;
}

VkSamplerAddressMode address(Wrap wrap) {
  switch (wrap) {
    case Wrap::mirror:
      return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case Wrap::clamp:
      return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    default:
      return VK_SAMPLER_ADDRESS_MODE_REPEAT;
  }
}

}  // namespace

DetailedSurfaces::DetailedSurfaces(vulkan::Device& device, const VisualDesc& desc)
    : white_(on_device(device, {"white", 1, 1, {255, 255, 255, 255}, false}, false)) {
  const std::vector<bool> is_relief = reliefs(desc);
  textures_.resize(desc.textures.size());
  materials_.resize(desc.materials.size());
  for (const Instance& instance : desc.instances) {
    const Material& material = desc.materials[instance.material];
    if (!material.detail || materials_[instance.material]) continue;
    for (const auto& layer : material.detail->layers)
      if (layer && !textures_[layer->texture])
        textures_[layer->texture] =
            on_device(device, desc.textures[layer->texture], is_relief[layer->texture]);
    materials_[instance.material] = make(device, desc, material);
    layout_ = materials_[instance.material]->sets[0].layout();
  }
}

VkDescriptorSet DetailedSurfaces::set_of(const SceneGeometry::Piece& piece) const {
  return materials_[*piece.material]->sets[follows_slants_ ? 1 : 0].get();
}

VkSampler DetailedSurfaces::sampler(vulkan::Device& device, Wrap wrap_u, Wrap wrap_v, bool nearest,
                                    bool along_slant) {
  vulkan::SamplerHandle& known = samplers_[{wrap_u, wrap_v, nearest, along_slant}];
  if (known.get() != VK_NULL_HANDLE) return known.get();
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  info.mipmapMode = along_slant ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.maxLod = VK_LOD_CLAMP_NONE;
  info.addressModeU = address(wrap_u);
  info.addressModeV = address(wrap_v);
  if (device.has_anisotropy() && !nearest && along_slant) {
    info.anisotropyEnable = VK_TRUE;
    info.maxAnisotropy = kAnisotropy;
  }
  known = vulkan::make_sampler(device, info);
  return known.get();
}

DetailedSurfaces::OnDevice DetailedSurfaces::make(vulkan::Device& device, const VisualDesc& desc,
                                                  const Material& material) {
  const auto& base = material.detail->layers[SurfaceDetail::base_colour];
  const gpu::MaterialData data =
      numbers_of(*material.detail, base && desc.textures[base->texture].cut_off.has_value());
  OnDevice made{{device, sizeof(data), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, vulkan::Place::upload}, {}};
  std::memcpy(made.numbers.mapped(), &data, sizeof(data));
  for (const bool along_slant : {false, true}) {
    std::vector<vulkan::Binding> bindings{
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT, made.numbers.get()}};
    for (std::size_t i = 0; i < SurfaceDetail::kKinds; ++i) {
      const auto& layer = material.detail->layers[i];
      const TextureLayer how = layer.value_or(TextureLayer{});
      bindings.push_back({static_cast<std::uint32_t>(i + 1), VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                          VK_SHADER_STAGE_FRAGMENT_BIT, VK_NULL_HANDLE,
                          layer ? textures_[layer->texture]->view() : white_.view(),
                          sampler(device, how.wrap_u, how.wrap_v, how.nearest, along_slant)});
    }
    made.sets[along_slant ? 1 : 0] = vulkan::DescriptorSet(device, bindings);
  }
  return made;
}

void DetailedSurfaces::bind(VkCommandBuffer commands, const Pipelines& pipelines,
                            const SceneGeometry::Piece& piece, const SceneGeometry::Piece* before,
                            VkDescriptorSet scene_set) const {
  const VkPipelineLayout layout = pipelines.detailed_layout.get();
  const bool is_after_detailed = before != nullptr && before->material;
  if (!is_after_detailed || before->look != piece.look)
    render::bind(commands, pipelines.detailed.at(piece.look).get(), layout, scene_set);
  if (!is_after_detailed || before->material != piece.material) {
    const VkDescriptorSet set = set_of(piece);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 1, 1, &set, 0, nullptr);
  }
  vkCmdSetCullMode(commands, is_two_sided(piece.look) ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
}

void DetailedSurfaces::record_blended(VkCommandBuffer commands, const Pipelines& pipelines,
                                      const SceneGeometry& geometry, VkDescriptorSet scene_set,
                                      const Sight& sight) const {
  geometry.bind(commands);
  const SceneGeometry::Piece* before = nullptr;
  const std::vector<SceneGeometry::Piece> pieces = geometry.blended(sight.eye, sight.layers);
  for (const SceneGeometry::Piece& piece : pieces) {
    bind(commands, pipelines, piece, std::exchange(before, &piece), scene_set);
    // Through the near side its far side is seen.
    if (is_two_sided(piece.look)) {
      vkCmdSetCullMode(commands, VK_CULL_MODE_FRONT_BIT);
      geometry.draw(commands, piece, sight);
      vkCmdSetCullMode(commands, VK_CULL_MODE_BACK_BIT);
    }
    geometry.draw(commands, piece, sight);
  }
}

void DetailedSurfaces::record_occluders(VkCommandBuffer commands, const Pipelines& pipelines,
                                        const SceneGeometry& geometry, VkDescriptorSet scene_set,
                                        const Sight& sight) const {
  geometry.bind(commands);
  for (const SceneGeometry::Piece& piece : geometry.detailed(sight.layers)) {
    const bool masked = is_masked(piece.look);
    const VkPipelineLayout layout = masked ? pipelines.detailed_layout.get() : pipelines.scene_layout.get();
    render::bind(commands, masked ? pipelines.masked_occluders.get() : pipelines.occluders.get(), layout,
                 scene_set);
    if (masked) {
      const VkDescriptorSet set = set_of(piece);
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 1, 1, &set, 0, nullptr);
    }
    vkCmdSetCullMode(commands, is_two_sided(piece.look) ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
    geometry.draw(commands, piece, sight);
  }
}

void DetailedSurfaces::record_entering(VkCommandBuffer commands, const Pipelines& pipelines,
                                       const SceneGeometry& geometry, VkDescriptorSet scene_set,
                                       const Sight& sight) const {
  geometry.bind(commands);
  const VkPipelineLayout layout = pipelines.detailed_layout.get();
  for (const SceneGeometry::Piece& piece : geometry.detailed(sight.layers)) {
    if (!is_scattering(piece.look)) continue;
    render::bind(commands, pipelines.entering.at(piece.look).get(), layout, scene_set);
    const VkDescriptorSet set = set_of(piece);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 1, 1, &set, 0, nullptr);
    vkCmdSetCullMode(commands, is_two_sided(piece.look) ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
    geometry.draw(commands, piece, sight);
  }
}

void DetailedSurfaces::record_shadows(VkCommandBuffer commands, const Pipelines& pipelines,
                                      const SceneGeometry& geometry, VkDescriptorSet scene_set,
                                      SceneGeometry::Casters which, const Sight& light) const {
  const std::vector<SceneGeometry::Piece> pieces = geometry.masked_casters(which, light.layers);
  if (pieces.empty()) return;
  geometry.bind(commands);
  const VkPipelineLayout layout = pipelines.detailed_layout.get();
  render::bind(commands, pipelines.masked_shadow.get(), layout, scene_set);
  for (const SceneGeometry::Piece& piece : pieces) {
    const VkDescriptorSet set = set_of(piece);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 1, 1, &set, 0, nullptr);
    vkCmdSetCullMode(commands, is_two_sided(piece.look) ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
    geometry.draw(commands, piece, light);
  }
}

}  // namespace fulcrum::render
