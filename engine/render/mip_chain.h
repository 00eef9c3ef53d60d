#pragma once
// A texture in ever smaller sizes, for surfaces that are seen from far away.

#include <cstdint>
#include <vector>

#include "engine/render/surface_detail.h"

namespace fulcrum::render {

// The first is the texture itself, each other half as wide and high, down to one pixel; each pixel is the
// mean of what it covers: of light where the texture is sRGB, of colours that are there where it has holes.
// Where alpha is cut off, it is kCutOff there, and but for the edge 0 or 1: in smaller sizes, it is the part
// of a pixel that is there.
std::vector<std::vector<std::uint8_t>> mip_chain(const Texture& texture);
inline constexpr float kCutOff = 0.5F;

// Of a texture of normals, whose alpha means nothing: there it has how far the normals are spread that a
// pixel stands for, the root mean square of how far they lean from their mean; in the first level, none. So
// M. Olano and D. Baker, "LEAN Mapping", 2010, though for each direction by itself.
std::vector<std::vector<std::uint8_t>> relief_chain(const Texture& texture);

// Of all its pixels; linear.
glm::vec3 mean_colour(const Texture& texture);

// How many that are, and their bytes together.
std::uint32_t mip_levels(const Texture& texture);
std::uint64_t mip_bytes(const Texture& texture);

}  // namespace fulcrum::render
