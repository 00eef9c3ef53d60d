#pragma once
// Which of the decor throws a shadow.

#include "engine/render/visual_desc.h"

namespace fulcrum::scenario {

// Of the instances that throw none, those are to that stand among the others that do, or only just beside
// them: a bracket on a wall. A wall itself is not, for the shadow map would cover all of it, and be coarse.
void let_decor_throw_shadows(render::VisualDesc& desc);

}  // namespace fulcrum::scenario
