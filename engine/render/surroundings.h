#pragma once
// Light from all around a scene, from a studio or a picture, as those ask for it who make it ready for
// shaders.

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

// A part of all directions, and what arrives from there.
struct Beam {
  glm::vec3 from;      // unit: its middle
  glm::vec3 radiance;  // in its mean; linear
  float share;         // of the whole sphere
};

struct Surroundings {
  // Radiance that arrives from a unit direction in the world, in the mean of about a degree; linear.
  std::function<glm::vec3(const glm::vec3& from)> radiance;
  // The same for sums, where some of it is as small and bright as a sun: all directions, each in one beam.
  // Empty: it changes little within three degrees, and sums may take it at single directions.
  std::vector<Beam> beams{};
};

Surroundings surroundings_of(const Ambient& ambient);

}  // namespace fulcrum::render
