#pragma once
// How a vertex lies in the vertex buffer.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace fulcrum::render {

struct Vertex {
  glm::vec3 position;                                      // m, mesh frame
  glm::vec3 normal;                                        // unit, mesh frame
  std::array<std::uint8_t, 4> colour{255, 255, 255, 255};  // linear, times the material's; the last is unused
};
static_assert(sizeof(Vertex) == 28);

}  // namespace fulcrum::render
