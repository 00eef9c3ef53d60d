#pragma once
// KHR_lights_punctual of a parsed glTF file. Internal to engine/assets.

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <optional>

#include "engine/assets/model_light.h"

namespace fulcrum {

// The light that a node refers to, as X_MN places it; none: it refers to none. Throws GltfFault.
std::optional<ModelLight> light_of(const tinygltf::Model& file, const tinygltf::Node& node,
                                   const Eigen::Affine3d& X_MN);

}  // namespace fulcrum
