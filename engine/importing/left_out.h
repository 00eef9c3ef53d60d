#pragma once
// What a material of a file looks like beyond its colour, metallic and roughness, and its pictures, all of
// which are told by themselves: a model that is written has none of it.

#include <assimp/material.h>

#include <string>
#include <vector>

#include "engine/assets/model_material.h"

namespace fulcrum::importing {

// By name, for people: "opacity", "emission". Empty: nothing is lost.
// Whether back faces are seen is told of glTF alone: of other formats assimp says so unasked.
std::vector<std::string> left_out_of(const aiMaterial& material);
std::vector<std::string> left_out_of(const MaterialDetail& material);

}  // namespace fulcrum::importing
