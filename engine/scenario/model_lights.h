#pragma once
// Lights that a model's file brings (KHR_lights_punctual) -> those that are drawn.

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/assets/model_light.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::scenario {

// Moves them with a model by X, which is invertible. With one that becomes larger they do: as much light
// falls on all of it as before.
void transform(std::vector<ModelLight>& lights, const Eigen::Affine3d& X);

// Its numbers, moved so, are such as are drawn.
bool can_be_drawn(const ModelLight& light);

// Appends them, `origin` (m, in M) lying at the origin of the frame that they are drawn in.
// carried_by: as PunctualLight has it.
void add_lights(render::VisualDesc& desc, const std::vector<ModelLight>& lights, const Vec3& origin,
                std::optional<std::size_t> carried_by, std::uint32_t layers);

}  // namespace fulcrum::scenario
