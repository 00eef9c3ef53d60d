#pragma once
// Radiance for every direction on a square: an octahedron unfolded about +y. Z. Cigolle et al., "A Survey of
// Efficient Representations for Independent Unit Vectors", JCGT 2014.

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace fulcrum::render {

// Along each side an eighth of the pixels repeats what lies beyond the fold, so that a filter never meets an
// edge.
struct OctahedralMap {
  std::uint32_t side = 0;           // pixels, a multiple of 8
  std::vector<glm::vec3> pixels{};  // (side x side) linear

  // Unit, of a pixel's middle; of one on the border, that of the pixel which it repeats.
  glm::vec3 direction(std::uint32_t column, std::uint32_t row) const;
  // Of the pixel inside the border that a unit direction lies in.
  std::size_t index(const glm::vec3& d) const;
  // In a unit direction, between the four nearest pixels.
  glm::vec3 at(const glm::vec3& d) const;
};

}  // namespace fulcrum::render
