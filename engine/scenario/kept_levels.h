#pragma once
// Coarser triangles for what is drawn from far away, made once and kept.

#include <string>
#include <vector>

#include "engine/assets/bake_cache.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::scenario {

// Gives every mesh that is large enough its levels of detail. Sentences: what is wrong with the cache.
std::vector<std::string> add_levels_of_detail(render::VisualDesc& desc, const BakeCache& cache);

}  // namespace fulcrum::scenario
