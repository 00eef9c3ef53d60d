#pragma once
// Materials, textures and images of a parsed glTF file -> those of a Model. Internal to engine/assets.

#include <tiny_gltf.h>

#include <vector>

#include "engine/assets/model.h"

namespace fulcrum {

// Fills the model's materials and images: those that a material names and no other. What a material asks for
// and is not drawn is told in Model::left_out. sizes: of each part, how many times as large its nodes make
// its mesh. Throws GltfFault.
void read_materials(const tinygltf::Model& file, const std::vector<double>& sizes, Model& model);

// Some texture is laid onto what is made of it; what no picture is laid onto need not know where it would
// lie. Any number may be asked for.
bool names_pictures(const tinygltf::Model& file, int material);

}  // namespace fulcrum
