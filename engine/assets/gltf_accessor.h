#pragma once
// Numbers out of a glTF file's buffers, every index and length checked first. Internal to engine/assets.

#include <tiny_gltf.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum {

// What is wrong with a file and what to do about it; caught in gltf.cpp, which names the file.
struct GltfFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A name that a file gives, as a sentence may have it.
std::string name_in_quotes(const std::string& name);

std::vector<std::uint8_t> read_bytes(const tinygltf::Model& file, int buffer_view);
std::vector<Vec3> read_vectors(const tinygltf::Model& file, int accessor);  // (n x 3) finite
std::vector<Vec3> read_colours(const tinygltf::Model& file, int accessor);  // (n x 3) 0 to 1
std::vector<std::array<float, 2>> read_coordinates(const tinygltf::Model& file,
                                                   int accessor);                    // (n x 2) finite
std::vector<std::uint32_t> read_indices(const tinygltf::Model& file, int accessor);  // (n)

}  // namespace fulcrum
