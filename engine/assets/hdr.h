#pragma once
// Radiance as files of the program Radiance have it (.hdr, .pic): G. Ward, "Real Pixels", Graphics Gems II,
// 1991; "Radiance File Formats" of its reference manual, radsite.lbl.gov/radiance/refer/filefmts.pdf.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum {

// What a file may be at most: bytes, and pixels along its longer side. A file with a pixel brighter than
// kBrightestHdr is damaged: the sun is ten thousand times darker, in a picture where a lit wall is 1.
inline constexpr std::uint64_t kLargestHdrFile = 64U << 20U;
inline constexpr std::uint32_t kWidestHdr = 4096;
inline constexpr float kBrightestHdr = 1e9F;

// A picture of all around, in rows from the top.
struct HdrPicture {
  std::uint32_t width = 0, height = 0;         // pixels
  std::vector<std::array<float, 3>> pixels{};  // (height x width) red, green, blue: 0 to kBrightestHdr
};

// Red, green and blue with a common exponent (RGBE), as they are or in runs of either kind; twice as wide as
// high. Errors are clauses: it is another format, it is damaged, it is larger than 4096 x 2048 pixels.
Result<HdrPicture> decode_hdr(std::span<const std::uint8_t> encoded);

}  // namespace fulcrum
