#pragma once

#include <filesystem>

namespace fulcrum {

// The file is a mesh of another format, by its name, that `fulcrum import` makes a .glb of.
bool is_importable(const std::filesystem::path& file);

}  // namespace fulcrum
