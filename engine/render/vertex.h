#pragma once
// How a vertex lies in the vertex buffer.

#include <glm/glm.hpp>

namespace fulcrum::render {

struct Vertex {
  glm::vec3 position;  // m, mesh frame
  glm::vec3 normal;    // unit, mesh frame
};
static_assert(sizeof(Vertex) == 24);

}  // namespace fulcrum::render
