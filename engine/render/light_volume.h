#pragma once
// What a scene's standing parts hide of the light from all around, in a grid of voxels over them: things too
// large or too far away for a depth image, and a tool that goes into a hole gets dark.
//
// Light is swept through the grid from 64 directions, from slice to slice; a voxel lets through what its
// triangles leave open. What arrives is kept in spherical harmonics of bands 0 and 1 (R. Green, "Spherical
// Harmonic Lighting: The Gritty Details", 2003).

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/render/environment.h"
#include "engine/render/visual_desc.h"
#include "engine/render/voxels.h"

namespace fulcrum::render {

inline constexpr glm::vec3 kLuminance{0.2126F, 0.7152F, 0.0722F};  // of linear sRGB

struct LightVolume {
  glm::vec3 low{0.0F};    // m, world: its first corner
  float voxel = 1.0F;     // m, its edge
  glm::uvec3 counts{1U};  // of voxels; x runs fastest
  // In a unit direction d, dot(xyz, d) + w: the part that is open; and irradiance / pi (luminance) facing d.
  std::vector<glm::vec4> open{{0.0F, 0.0F, 0.0F, 1.0F}};
  std::vector<glm::vec4> received{glm::vec4(0.0F)};
  std::vector<glm::vec4> sent_on{
      glm::vec4(0.0F)};      // rgb: radiance in the mean of all directions that are not open
  glm::vec4 unhidden{0.0F};  // received, where nothing hides anything
  TextureMeans means{};      // of what it was made of, for the mirror volume of the same
};

// The key light as a place sees it.
struct KeyBeam {
  glm::vec3 towards;   // unit
  glm::vec3 arriving;  // irradiance / pi facing it, where nothing hides it
  float far;           // m, how far away it is
};

// nearest: m, no light is nearer than that.
KeyBeam key_beam(const KeyLight& key, const glm::vec3& at, float nearest);

// What it is to be made for: all layers at once where all that stands is seen together, else each layer by
// itself.
std::vector<std::uint32_t> light_volume_layers(const VisualDesc& desc);

// Of what stands and is in one of these layers; without any one voxel, which is open.
// received: irradiance of the same surroundings.
LightVolume make_light_volume(const VisualDesc& desc, std::uint32_t layers, const Surroundings& around,
                              const Irradiance& received);

// Voxels of all of them, before they are made; 1 where nothing stands.
std::uint64_t light_volume_voxels(const VisualDesc& desc);

}  // namespace fulcrum::render
