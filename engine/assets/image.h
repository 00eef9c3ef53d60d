#pragma once
// Pictures of textures: PNG by libpng, JPEG by libjpeg-turbo.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum {

struct Image {
  std::uint32_t width = 0, height = 0;  // pixels
  std::vector<std::uint8_t> rgba;  // (4 x width x height) row by row from the top; as the file encodes it
};

// Its first bytes are those of a PNG or a JPEG file.
bool is_picture(std::span<const std::uint8_t> encoded);

// Grey becomes red, green and blue alike; without an alpha it is opaque; 16 bits are cut to 8. Errors are
// clauses: it is damaged, it is larger than 8192 pixels a side.
Result<Image> decode_image(std::span<const std::uint8_t> encoded);

}  // namespace fulcrum
