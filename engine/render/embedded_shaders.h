#pragma once
// The SPIR-V that is built into the program; defined in a source that tools/cmake/FulcrumShaders.cmake
// writes.

#include <cstdint>
#include <span>
#include <string_view>

namespace fulcrum::render {

// By file name, as "tone.frag"; empty where there is no such shader.
std::span<const std::uint32_t> embedded_shader(std::string_view name);

}  // namespace fulcrum::render
