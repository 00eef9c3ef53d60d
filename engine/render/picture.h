#pragma once
// A finished picture in the program's memory, and writing it to a file.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/vulkan/result.h"

namespace fulcrum::render {

struct Picture {
  std::uint32_t width = 0;         // pixels
  std::uint32_t height = 0;        // pixels
  std::vector<std::uint8_t> rgba;  // (height x width x 4) rows from the top, sRGB encoded, alpha 255
};

// Writes an 8-bit RGB file, quickly rather than small. Fails with a sentence where the file cannot be
// written.
std::optional<vulkan::Error> write_png(const std::filesystem::path& file, const Picture& picture);

// The same file as bytes, small rather than quickly; empty where memory does not suffice.
std::string png_bytes(const Picture& picture);

}  // namespace fulcrum::render
