#pragma once
// Scene radiance of a picture that another renderer has drawn, as a 16-bit PNG.

#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "engine/vulkan/result.h"

namespace fulcrum::render {

struct Radiance {
  std::uint32_t width = 0, height = 0;  // pixels
  // (height x width) rows from the top: linear, already times what the scene covers of the pixel; that, 0..1
  std::vector<glm::vec4> pixels;
};

// Of a side: what is larger is no reference.
inline constexpr std::uint32_t kMostRadiancePixels = 4096;

// The bytes of a file of red, green, blue and alpha, 16 bits each: of v / 65535 the square is
// c / (1 + the largest c), alpha as it is. Fails with a clause where it is none such.
vulkan::Result<Radiance> read_radiance(std::string_view png);

}  // namespace fulcrum::render
