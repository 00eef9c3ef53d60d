#pragma once
// The surroundings of every scene: a photographer's studio of a sky, a ground and soft boxes that metal can
// mirror, as the radiance that arrives from each direction. The picture and its path-traced references both
// take their light from here.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

// Radiance from a unit direction in the world; linear.
glm::vec3 studio_radiance(const Ambient& ambient, const glm::vec3& from);

// The same as an equirectangular picture, row by row from the top (+y), width x height pixels. The middle of
// column i looks along azimuth (i + 0.5) / width turns from -z over +x.
std::vector<glm::vec3> studio_panorama(const Ambient& ambient, std::uint32_t width, std::uint32_t height);

}  // namespace fulcrum::render
