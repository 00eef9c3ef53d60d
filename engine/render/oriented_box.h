#pragma once
// A box around a mesh that lies as the mesh does: a pane that was turned before it was exported has a thin
// one.

#include <glm/glm.hpp>
#include <span>

#include "engine/render/bounds.h"

namespace fulcrum::render {

struct OrientedBox {
  glm::mat3 axes{1.0F};  // columns, unit and square to each other, of the mesh's frame
  Bounds bounds;         // along them
};

// Along the principal axes of the positions, or along those of their frame where that box is smaller. Of at
// least one point.
OrientedBox oriented_box_of(std::span<const glm::vec3> positions);

// From a point (m) to the nearest place of a box that `X` has placed; from within to its farthest corner,
// since then its far sides are what is seen of it.
float distance_to(const OrientedBox& box, const glm::mat4& X, const glm::vec3& point);

}  // namespace fulcrum::render
