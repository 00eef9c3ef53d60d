#pragma once
// A parsed glTF file -> Model: nodes, meshes and materials. Internal to engine/assets.

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "engine/assets/model.h"

namespace fulcrum {

// why_unread: of each image, why its own file could not be read; empty: it was, or it needs none. Throws
// GltfFault.
Model model_from_gltf(const tinygltf::Model& file, const std::vector<std::string>& why_unread);

}  // namespace fulcrum
