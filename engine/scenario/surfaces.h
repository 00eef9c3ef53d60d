#pragma once
// Materials and textures of a model -> those that are drawn.

#include <cstdint>
#include <optional>

#include "engine/assets/model.h"
#include "engine/render/visual_desc.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

// Of the textures of a scene, decoded, in all their sizes.
inline constexpr std::uint64_t kMostTextureBytes = 1U << 30U;

// Appends them in their order. Fails with a clause about the texture that cannot be decoded, or with which
// all of them take more than `most` bytes; the model's textures are then left out.
std::optional<Error> add_materials(render::VisualDesc& desc, const Model& model,
                                   std::uint64_t most = kMostTextureBytes);

}  // namespace fulcrum::scenario
