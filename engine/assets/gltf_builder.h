#pragma once
// Parts and materials -> the tables of a glTF file. Internal to what writes models: the program and the
// generators of its content. The same parts give the same bytes.

#include <tiny_gltf.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum {

struct GltfPart {
  const std::string& name;
  int material = 0;                               // of the file's
  const std::vector<Eigen::Vector3f>& positions;  // (n x 3) m
  const std::vector<Eigen::Vector3f>& normals;    // (n x 3) unit
  const std::vector<Eigen::Vector3f>& colours;    // (n x 3) linear, or none
  const std::vector<std::uint32_t>& indices;      // (3 m)
  const std::vector<Eigen::Vector2f>& uv;         // (n x 2) of the material's pictures, or none
  const std::vector<Eigen::Vector4f>& tangents;   // (n x 4) of its relief, or none
};

// A file with one scene of that name and nothing in it.
tinygltf::Model empty_gltf(const std::string& name, const std::string& generator);

// base_colour: linear; metallic and roughness: 0 to 1.
tinygltf::Material gltf_material(const std::string& name, const std::array<double, 3>& base_colour,
                                 double metallic, double roughness);

// A picture as the bytes of a PNG file; its index among the file's textures.
int add_picture(tinygltf::Model& gltf, const std::string& name, const std::vector<std::uint8_t>& png);

void add_part(tinygltf::Model& gltf, const GltfPart& part);  // as a node and a mesh of its own

}  // namespace fulcrum
