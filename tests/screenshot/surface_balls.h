#pragma once
// One ball for each of what a surface may have; docs/looks.md lists them.

#include <vector>

#include "engine/render/visual_desc.h"

namespace fulcrum::test {

// Behind: base colour, metal-rough, normal, occlusion, emissive. Before: mask, blend, clear coat, sheen,
// transmission.
render::VisualDesc surface_balls();

// A ball of that radius (m) that a picture goes round four times and down twice, of the first set of
// coordinates.
render::Mesh unwrapped_ball(float radius);

// The pictures that those balls have: checks as base colour, as metal and roughness, a dome's normals, a rim
// of occlusion, checks that glow, a red one with a hole.
std::vector<render::Texture> painted_textures();

}  // namespace fulcrum::test
