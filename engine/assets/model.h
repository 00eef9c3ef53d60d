#pragma once
// A model as files describe it: parts to draw and to touch, in the model's frame M (right-handed, Y up,
// metres).

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/model_light.h"
#include "engine/assets/model_material.h"
#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

struct ModelPart {
  std::string name;
  std::vector<Vec3> positions;  // (n x 3) m, node transforms applied
  std::vector<Vec3> normals;    // (n x 3) unit; the file's, or made from the triangles
  std::vector<Vec3> colours;    // (n x 3) linear, 0 to 1, times the material's; or none
  // (n x 4) where each vertex is in the pictures of its material: u, v of the file's first set and of its
  // second, v downwards; none: the material has no pictures, or the file does not say
  std::vector<std::array<float, 4>> uv;
  std::vector<std::uint32_t> indices;  // (3 m), counter-clockwise seen from outside
  std::uint32_t material = 0;          // into Model::materials
  // What the file's author has marked its object with, as glTF custom properties; empty: nothing.
  std::string marked_role;      // fulcrum_role
  std::string marked_material;  // fulcrum_material: of what a blow on it sounds like
};

struct Model {
  std::vector<ModelPart> parts;
  std::vector<ModelMaterial> materials;  // at least one
  std::vector<ModelImage> images{};      // what materials name
  std::vector<ModelLight> lights{};      // in the order of the file's nodes
  std::vector<std::string> left_out{};   // what of the file's looks is not drawn: a clause each
  std::vector<std::string> beside{};     // files that its file names, from the folder of that
};

// Moves what the part has by X, which is invertible: positions, and normals so that they stay normal to the
// surface. A mirror image is wound the other way, so that its outside stays outside.
void transform(ModelPart& part, const Eigen::Affine3d& X);

// Every part's triangles in one soup: what build_solid() takes.
TriangleMesh to_triangle_mesh(const Model& model);

}  // namespace fulcrum
