#pragma once
// Materials, textures and images of a parsed glTF file -> those of a Model. Internal to engine/assets.

#include <tiny_gltf.h>

#include <array>
#include <string>
#include <vector>

#include "engine/assets/model.h"

namespace fulcrum {

// What a model's part leaves behind that a material's look depends on.
struct PartFacts {
  double size = 1;                              // how many times as large its nodes make its mesh
  std::array<bool, 2> has_uv = {false, false};  // TEXCOORD_0, TEXCOORD_1
};

// Fills the model's materials and images: those that a material names of which a part is made, and no other.
// What such a material asks for and is not drawn is told in Model::left_out. facts: of each part; why_unread:
// of each image, as model_from_gltf() has it. Throws GltfFault.
void read_materials(const tinygltf::Model& file, const std::vector<PartFacts>& facts,
                    const std::vector<std::string>& why_unread, Model& model);

// Some texture is laid onto what is made of it; what no picture is laid onto need not know where it would
// lie. Any number may be asked for.
bool names_pictures(const tinygltf::Model& file, int material);

}  // namespace fulcrum
