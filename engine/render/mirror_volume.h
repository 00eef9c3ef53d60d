#pragma once
// What metal mirrors of what stands: radiance and cover in a grid of voxels and its coarser levels, through
// which shaders follow a cone as wide as a mirror's roughness makes it.
//
// Voxel cone tracing: C. Crassin et al., "Interactive Indirect Illumination Using Voxel Cone Tracing", 2011.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/render/light_volume.h"

namespace fulcrum::render {

struct MirrorVolume {
  glm::vec3 low{0.0F};    // m, world: its first corner
  float voxel = 1.0F;     // m, its edge, of the finest level
  glm::uvec3 counts{1U};  // of voxels of that level; x runs fastest
  // Each level of half as many along each side. w: the part of light that a voxel hides; rgb: radiance that
  // it sends on, times that.
  std::vector<std::vector<glm::vec4>> levels{{glm::vec4(0.0F)}};
  // Of all levels but the finest, of the surfaces in a voxel: the mean way that they face, and its mean
  // weighted by the luminance that they send on, both times w above. Walls are brighter on one side, and are
  // seen from one.
  std::vector<std::vector<glm::vec4>> facing{{glm::vec4(0.0F)}}, bright{{glm::vec4(0.0F)}};
};

// Of what stands and is in one of these layers. light: of the same; received: irradiance of the surroundings.
MirrorVolume make_mirror_volume(const VisualDesc& desc, std::uint32_t layers, const LightVolume& light,
                                const Irradiance& received);

// Voxels of all of them and of how they face, with their coarser levels, before they are made. 0: no metal is
// such that it mirrors its neighbours, or nothing stands.
std::uint64_t mirror_volume_voxels(const VisualDesc& desc);

}  // namespace fulcrum::render
