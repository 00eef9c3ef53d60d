#pragma once
// One ball for each of what a surface may have; docs/looks.md lists them.

#include "engine/render/visual_desc.h"

namespace fulcrum::test {

// Behind: base colour, metal-rough, normal, occlusion, emissive. Before: mask, blend, clear coat, sheen,
// transmission.
render::VisualDesc surface_balls();

}  // namespace fulcrum::test
