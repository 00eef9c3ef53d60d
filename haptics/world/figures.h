#pragma once
// Every figure of a scene, in one list, with the range that it must lie in.

#include <optional>

#include "haptics/math/result.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum {

// The first figure that is not finite or out of its range, as a sentence that names it as a scenario does.
// How figures go together is World::build's to judge. A member that a Desc is given and that is forgotten
// here does not compile.
std::optional<Error> refuse_figures(const SceneDesc& desc);

}  // namespace fulcrum
