#pragma once
// What stands in a scene, in voxels: what light is swept through (light_volume.h), and what metal mirrors
// (mirror_volume.h).

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

struct VoxelGrid {
  glm::vec3 low{0.0F};    // m, world: its first corner
  float voxel = 1.0F;     // m, its edge
  glm::uvec3 counts{1U};  // of voxels; x runs fastest

  std::size_t size() const { return std::size_t{counts.x} * counts.y * counts.z; }
  // Of the voxel around a point; none: it lies outside.
  std::optional<std::size_t> index(const glm::vec3& at) const;
  glm::uvec3 cell(std::size_t index) const;
  glm::vec3 middle(std::size_t index) const;
};

// What the triangles in a voxel amount to.
struct Matter {
  float area = 0.0F;       // m^2
  glm::vec3 normal{0.0F};  // times area
  glm::vec3 colour{0.0F};  // what they send on of what they receive, times area
};

// It stands, is in one of these layers, and is not seen through.
bool hides_light(const VisualDesc& desc, const Instance& instance, std::uint32_t layers);

// Around what stands and throws a shadow, with an open rim of three voxels; a floor or wall near it belongs
// to it as far as it is near. None: nothing stands. most: voxels along its longest side.
std::optional<VoxelGrid> voxel_grid(const VisualDesc& desc, std::uint32_t layers, float most);

// The mean colour (linear) of each texture of the description; none: no surface that hides light in these
// layers has it as its base colour. Every pixel is read for it, so that it is found once and handed on.
using TextureMeans = std::vector<std::optional<glm::vec3>>;
TextureMeans texture_means(const VisualDesc& desc, std::uint32_t layers);

// Of each voxel. piece: the longest edge, in voxels, of the pieces that triangles are cut into, each of which
// belongs to one voxel: pieces as large as a voxel leave some voxels of a plane half empty. means: of the
// same layers.
std::vector<Matter> matter_of(const VisualDesc& desc, std::uint32_t layers, const VoxelGrid& grid,
                              float piece, const TextureMeans& means);

// Unit; none: as much of it faces one way as the other.
std::optional<glm::vec3> facing(const Matter& matter);

// The part of light that a voxel lets through, of each.
std::vector<float> passing(const VoxelGrid& grid, const std::vector<Matter>& matter);

}  // namespace fulcrum::render
