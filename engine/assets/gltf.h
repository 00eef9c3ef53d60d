#pragma once
// glTF 2.0 -> Model, through tinygltf. Animation, skins and morph targets are left out, and points and lines,
// which Model::left_out tells; names are on one line, without what a terminal would obey. Which extensions of
// materials are drawn, model_material.h says, and of lights model_light.h.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "engine/assets/model.h"
#include "haptics/math/result.h"

namespace fulcrum {

// .glb, or .gltf with its buffers beside it. The file and all that it names lie in `folder`. Every fault is a
// sentence that names the file, what is wrong and what to do: missing, unreadable, truncated, not glTF, no
// triangles, indices or accessors out of range, numbers that are not finite, and what is not supported
// (sparse accessors, quantised or compressed meshes).
Result<Model> load_gltf(const std::filesystem::path& folder, const std::filesystem::path& file);

// The same from the bytes of a .glb. `name` stands in sentences for the file.
Result<Model> parse_glb(std::span<const std::byte> bytes, std::string_view name);

}  // namespace fulcrum
