#include <optional>
#include <set>

#include "engine/render/ghost_edges.h"
#include "engine/render/light_volume.h"
#include "engine/render/look.h"
#include "engine/render/mip_chain.h"
#include "engine/render/mirror_volume.h"
#include "engine/render/plan.h"

namespace fulcrum::render {

SceneFacts facts_of(const VisualDesc& desc) {
  SceneFacts facts;
  for (const Mesh& mesh : desc.meshes) {
    facts.vertices += mesh.positions.size();
    facts.indices += mesh.indices.size();
    if (!mesh.levels) continue;
    facts.levelled += mesh.indices.size() / 3;
    facts.coarser += mesh.levels->indices.size() - mesh.indices.size();
    facts.pieces += mesh.levels->pieces.size();
    for (const LevelsOfDetail::Piece& piece : mesh.levels->pieces)
      facts.coarsest += piece.levels.back().count / 3;
  }
  facts.instances = desc.instances.size();
  facts.voxels = light_volume_voxels(desc);
  facts.mirrored = mirror_volume_voxels(desc);
  std::set<std::size_t> placed, textures, materials;  // meshes with places in textures, these, detailed ones
  std::set<std::uint32_t> looks;
  for (const Instance& instance : desc.instances) {
    const Material& material = desc.materials[instance.material];
    const std::optional<std::uint32_t> look = look_of(material);
    if (throws_shadow(instance, material)) {
      ++facts.casters;
      facts.moving_casters += instance.movable ? 1 : 0;
    }
    if (!look) {
      ++facts.plain;
      continue;
    }
    looks.insert(*look);
    materials.insert(instance.material);
    facts.scattering += is_scattering(*look) ? 1 : 0;
    if (reads_places(*look)) placed.insert(instance.mesh);
    for (const auto& layer : material.detail->layers)
      if (layer) textures.insert(layer->texture);
  }
  facts.looks.assign(looks.begin(), looks.end());
  facts.detailed = materials.size();
  for (const std::size_t mesh : placed) facts.placed_vertices += desc.meshes[mesh].positions.size();
  facts.textures = textures.size();
  for (const std::size_t texture : textures) facts.texture_bytes += mip_bytes(desc.textures[texture]);
  facts.lights = desc.lights.size();
  facts.markers = desc.markers.size();
  for (const Ghost& ghost : desc.ghosts) {
    // All of them copy the same instances: if one has no edges, none has.
    if (const std::size_t edges = GhostEdges(desc, ghost).size(); edges > 0)
      facts.ghost_edges.push_back(edges);
  }
  facts.picture = desc.ambient.picture.has_value();
  facts.picture_seen = facts.picture && desc.ambient.picture->seen;
  facts.key_light = desc.key_light.has_value();
  facts.key_light_casts = desc.key_light && desc.key_light->casts_shadow;
  facts.key_light_wide = desc.key_light && desc.key_light->diameter > 0.0F;
  return facts;
}

}  // namespace fulcrum::render
