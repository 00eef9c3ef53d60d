#pragma once
// Model -> glTF 2.0, as a .glb.

#include <string>

#include "engine/assets/model.h"

namespace fulcrum {

// The bytes of the file; load_gltf() reads the same model from them, to single precision. A part without
// triangles is left out. name: of the scene in it; generator: the program that made it.
std::string to_glb(const Model& model, const std::string& name, const std::string& generator);

}  // namespace fulcrum
