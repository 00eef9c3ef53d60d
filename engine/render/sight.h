#pragma once
// What of a scene a view sees, and how finely.

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/render/bounds.h"

namespace fulcrum::render {

struct Sight {
  glm::mat4 clip_from_world{1.0F};  // depth from 0 to w
  glm::vec3 eye{0.0F};              // m, world
  float per_metre = 0.0F;           // m that may be off at a distance of 1 m
  float anywhere = 0.0F;            // m that may be off at any distance besides
  std::uint32_t layers = 1;         // that it sees

  // False: all of the box is beside the view, or behind it.
  bool sees(const Bounds& box) const;
  // m, to the nearest point of the box.
  float distance(const Bounds& box) const;
  // m that what fills the box may be off without being seen.
  float tolerance(const Bounds& box) const { return anywhere + per_metre * distance(box); }
};

}  // namespace fulcrum::render
