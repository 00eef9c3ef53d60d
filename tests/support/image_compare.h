#pragma once
// Compares a picture with a golden one, pixel by pixel.
//
// Goldens are drawn by the software rasteriser (llvmpipe), which gives the same picture on every run of a
// machine. Pictures of two machines differ by one in a few pixels, 0.42 % of those of plate. About half of
// these are edges of panels, which Dear ImGui, as Debian compiles it, makes with rsqrtss: the last bits of
// that are each processor maker's own. The others lie on surfaces with textures of normals, and why is not
// known. A graphics card rounds otherwise: draw goldens with llvmpipe.

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/render/picture.h"

namespace fulcrum::test {

struct CompareOptions {
  int max_lsb = 2;                       // the largest difference of a channel that passes, of 255
  std::size_t max_pixels = 50;           // how many pixels may differ by more than one
  double max_share_by_one = 0.01;        // of all pixels, how many may differ by one
  std::filesystem::path failure_folder;  // where pictures of a failure go; empty: nowhere
};

struct Comparison {
  bool passed = false;
  int largest_lsb = 0;             // over all pixels and channels
  std::size_t pixels_by_one = 0;   // that differ by one
  std::size_t pixels_by_more = 0;  // that differ by more
  std::string sentence;            // what was found, and where the pictures are
};

// Of two pictures in memory; another size never passes.
Comparison compare(const render::Picture& actual, const render::Picture& golden,
                   const CompareOptions& options);

// Of a picture and a PNG file. On failure writes NAME.actual.png and NAME.diff.png (differences times 16, on
// black) to the failure folder. A golden that is missing fails, and the actual picture is written for
// somebody to look at.
Comparison compare(const render::Picture& actual, const std::filesystem::path& golden,
                   const CompareOptions& options);

// An 8-bit PNG file; fails with a sentence where it cannot be read.
vulkan::Result<render::Picture> read_png(const std::filesystem::path& file);

}  // namespace fulcrum::test
