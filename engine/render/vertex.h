#pragma once
// How a vertex lies in the vertex buffer.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace fulcrum::render {

struct Vertex {
  static constexpr std::uint16_t kOne = 65535;

  glm::vec3 position;  // m, mesh frame
  glm::vec3 normal;    // unit, mesh frame
  // Linear, in parts of kOne, times the material's; the last is unused. Of 255 linear parts the darkest would
  // be 13 of a screen's 255 apart.
  std::array<std::uint16_t, 4> colour{kOne, kOne, kOne, kOne};
};
static_assert(sizeof(Vertex) == 32);

}  // namespace fulcrum::render
