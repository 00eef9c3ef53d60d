#pragma once
// Boxes around what is drawn.

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace fulcrum::render {

// An axis-aligned box.
struct Bounds {
  glm::vec3 low{0.0F};   // m
  glm::vec3 high{0.0F};  // m
};

// Of at least one point.
Bounds bounds_of(std::span<const glm::vec3> positions);

std::array<glm::vec3, 8> corners(const Bounds& bounds);

// The box around a transformed box.
Bounds transformed(const Bounds& bounds, const glm::mat4& X);

// The box around both.
Bounds united(const Bounds& a, const Bounds& b);

}  // namespace fulcrum::render
