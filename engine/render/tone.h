#pragma once
// What shaders/tone.frag makes of scene radiance, for pictures that others have drawn.

#include <glm/glm.hpp>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

// Linear radiance to what a screen is told, 0..1; without the shader's noise.
glm::vec3 tone_mapped(const glm::vec3& radiance);

// What shaders/background.frag has where nothing is hit. v: 0 at the top of the picture .. 1 at its bottom.
glm::vec3 background_radiance(const Background& background, float v);

}  // namespace fulcrum::render
