#pragma once
// Where shaders come from: the program itself, or a folder of GLSL that is watched and compiled while
// running.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/vulkan/result.h"

namespace fulcrum::render {

class ShaderLibrary {
public:
  // An empty folder: the shaders that are built in. Else `folder` holds the repository's shaders/; fails
  // with the compiler's sentences.
  static vulkan::Result<ShaderLibrary> open(const std::filesystem::path& folder);

  // SPIR-V by file name ("tone.frag"); valid until the next refresh(). Throws vulkan::Failure for an unknown
  // name.
  std::span<const std::uint32_t> code(const std::string& name) const;

  // True when the folder has changed and all of it compiled; a sentence when it does not compile: what was
  // loaded before stays in use. A version of the folder is compiled, and complained about, once.
  vulkan::Result<bool> refresh();

private:
  using Compiled = std::map<std::string, std::vector<std::uint32_t>>;

  std::filesystem::path folder_;
  std::filesystem::file_time_type newest_;
  Compiled compiled_;
};

}  // namespace fulcrum::render
