#include "engine/render/shader_library.h"

#include <algorithm>

#include "engine/render/embedded_shaders.h"
#include "engine/vulkan/shader_compiler.h"

namespace fulcrum::render {
namespace fs = std::filesystem;
using vulkan::Error;
using vulkan::Result;

namespace {

fs::file_time_type newest_in(const fs::path& folder) {
  fs::file_time_type newest = fs::file_time_type::min();
  std::error_code ignored;  // an editor may be replacing a file this moment; the next look sees it
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, ignored))
    if (entry.is_regular_file(ignored)) newest = std::max(newest, entry.last_write_time(ignored));
  return newest;
}

}  // namespace

Result<ShaderLibrary> ShaderLibrary::open(const fs::path& folder) {
  ShaderLibrary library;
  if (folder.empty()) return library;
  if (!fs::is_directory(folder)) {
    return Error{"The shader folder " + folder.string() +
                 " does not exist; leave it out to use the built-in shaders."};
  }
  library.folder_ = folder;
  library.newest_ = fs::file_time_type::min();
  if (const Result<bool> loaded = library.refresh(); !loaded) return loaded.error();
  return library;
}

std::span<const std::uint32_t> ShaderLibrary::code(const std::string& name) const {
  const auto compiled = compiled_.find(name);
  const std::span<const std::uint32_t> code =
      compiled != compiled_.end() ? std::span(compiled->second) : embedded_shader(name);
  if (code.empty()) {
    throw vulkan::Failure("Fulcrum was built without the shader " + name +
                          "; build it again from a clean folder.");
  }
  return code;
}

Result<bool> ShaderLibrary::refresh() {
  if (folder_.empty()) return false;
  const fs::file_time_type newest = newest_in(folder_);
  if (newest <= newest_) return false;
  newest_ = newest;
  Compiled compiled;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    const fs::path& file = entry.path();
    if (file.extension() != ".vert" && file.extension() != ".frag") continue;
    Result<std::vector<std::uint32_t>> code = vulkan::compile_shader(file);
    if (!code) return code.error();
    compiled.emplace(file.filename().string(), std::move(*code));
  }
  compiled_ = std::move(compiled);
  return true;
}

}  // namespace fulcrum::render
