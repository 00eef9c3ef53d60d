#pragma once
// Whether a VisualDesc can be drawn.

#include <optional>

#include "engine/render/visual_desc.h"
#include "engine/vulkan/result.h"

namespace fulcrum::render {

// The first mistake in a sentence that names what is wrong.
std::optional<vulkan::Error> validate(const VisualDesc& desc);

}  // namespace fulcrum::render
