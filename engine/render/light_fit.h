#pragma once
// Where the shadow map looks: as closely as possible at what throws a shadow.

#include <glm/glm.hpp>
#include <span>

#include "engine/render/bounds.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::render {

struct LightFit {
  glm::mat4 clip_from_world{1.0F};  // depth 0 near the light, 1 far
  float texel = 0.0F;  // its width in the world: m; of a spot, m for each metre of the way along its axis; 0:
                       // nothing throws a shadow
  float spread = 0.0F;  // how wide half the light is, in the map's width per unit of depth: seen from a
                        // place, what is that much nearer to the light hides some of it out to so far beside
  float nearest = 0.0F, farthest = 0.0F;  // m along a spot's axis, that the depths 0 and 1 are
};

// `casters`: at least one box in the world. What lies wholly beside a spot's cone, or behind it, does not
// count; what reaches nearer to it than a hundredth of the farthest is cut off there. Shadows that fall
// beyond them are kept: a point outside the map's depth range is compared at its far end. Sizes and places of
// a directional fit are rounded, so that a moving caster does not make the edges of all the other shadows
// crawl.
LightFit fit_light(const KeyLight& light, std::span<const Bounds> casters, int map_size);

// How wide a map that sees all of these boxes, of which there is at least one, is in the world, seen from far
// away along the light (m).
float width_seen(const KeyLight& light, std::span<const Bounds> casters);

// A fit that was made for casters elsewhere covers these as well, and not much more finely would another:
// what stands need not be drawn again for every move of what does not.
bool still_fits(const LightFit& fit, const KeyLight& light, std::span<const Bounds> casters, int map_size);

}  // namespace fulcrum::render
