#pragma once
// Materials and textures of a model -> those that are drawn.

#include <optional>

#include "engine/assets/model.h"
#include "engine/render/visual_desc.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

// Appends them in their order. Fails with a clause about the texture that cannot be decoded; the model's
// textures are then left out.
std::optional<Error> add_materials(render::VisualDesc& desc, const Model& model);

}  // namespace fulcrum::scenario
