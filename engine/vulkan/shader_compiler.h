#pragma once
// GLSL to SPIR-V while the program runs, for shaders that are being worked on.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/vulkan/result.h"

namespace fulcrum::vulkan {

// Compiles NAME.vert or NAME.frag; #include is looked up beside the including file, then in the shader's
// folder. Fails with the compiler's own sentences, which name file and line. Not for several threads at
// once.
Result<std::vector<std::uint32_t>> compile_shader(const std::filesystem::path& file);

}  // namespace fulcrum::vulkan
