#pragma once
// Which of the decor throws a shadow.

#include "engine/render/visual_desc.h"

namespace fulcrum::scenario {

// Lets instances throw a shadow that do not yet, but stand among the ones that do, or only just beside them,
// such as a bracket on a wall. One that makes the shadow map more than a tenth wider is left as it is, for
// the map would be coarse: a floor, or the wall itself; and one that a spot's lamp stands in.
void let_decor_throw_shadows(render::VisualDesc& desc, const render::KeyLight& light);

}  // namespace fulcrum::scenario
