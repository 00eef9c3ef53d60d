#pragma once
// A parsed glTF file -> Model: nodes, meshes and materials. Internal to engine/assets.

#include <tiny_gltf.h>

#include "engine/assets/model.h"

namespace fulcrum {

Model model_from_gltf(const tinygltf::Model& file);  // throws GltfFault

}  // namespace fulcrum
