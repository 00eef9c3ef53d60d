#include "engine/render/mip_chain.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace fulcrum::render {
namespace {

float linear_of(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float encoded_of(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

std::uint8_t to_byte(float x) {
  return static_cast<std::uint8_t>(std::clamp(255.0F * x + 0.5F, 0.0F, 255.0F));
}

struct Level {
  std::uint32_t width, height;
  std::vector<glm::vec4> pixels;  // linear; colours times alpha where the texture is sRGB
};

Level first_level(const Texture& texture) {
  std::array<float, 256> decoded{};
  for (std::size_t i = 0; i < 256; ++i) {
    const float x = static_cast<float>(i) / 255.0F;
    decoded[i] = texture.srgb ? linear_of(x) : x;
  }
  Level level{texture.width, texture.height, {}};
  level.pixels.reserve(std::size_t{texture.width} * texture.height);
  for (std::size_t i = 0; i + 3 < texture.rgba.size(); i += 4) {
    const float alpha = static_cast<float>(texture.rgba[i + 3]) / 255.0F;
    const float weight = texture.srgb ? alpha : 1.0F;
    level.pixels.emplace_back(weight * decoded[texture.rgba[i]], weight * decoded[texture.rgba[i + 1]],
                              weight * decoded[texture.rgba[i + 2]], alpha);
  }
  return level;
}

// Of a side that is odd, the last pixel of the smaller one covers three.
Level halved(const Level& from) {
  Level to{std::max(from.width / 2, 1U), std::max(from.height / 2, 1U), {}};
  to.pixels.reserve(std::size_t{to.width} * to.height);
  const auto covers = [](std::uint32_t i, std::uint32_t small, std::uint32_t large) {
    return std::pair(i * large / small, (i + 1) * large / small);
  };
  for (std::uint32_t y = 0; y < to.height; ++y) {
    const auto [top, bottom] = covers(y, to.height, from.height);
    for (std::uint32_t x = 0; x < to.width; ++x) {
      const auto [left, right] = covers(x, to.width, from.width);
      glm::vec4 sum(0.0F);
      for (std::uint32_t row = top; row < bottom; ++row)
        for (std::uint32_t column = left; column < right; ++column)
          sum += from.pixels[std::size_t{row} * from.width + column];
      to.pixels.push_back(sum / static_cast<float>((bottom - top) * (right - left)));
    }
  }
  return to;
}

std::vector<std::uint8_t> bytes_of(const Level& level, bool srgb) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * level.pixels.size());
  for (const glm::vec4& pixel : level.pixels) {
    const float weight = srgb && pixel.a > 0.0F ? 1.0F / pixel.a : 1.0F;
    for (int i = 0; i < 3; ++i) {
      const float x = weight * pixel[i];
      bytes.push_back(to_byte(srgb ? encoded_of(x) : x));
    }
    bytes.push_back(to_byte(pixel.a));
  }
  return bytes;
}

}  // namespace

std::vector<std::vector<std::uint8_t>> mip_chain(const Texture& texture) {
  std::vector<std::vector<std::uint8_t>> levels{texture.rgba};
  const std::uint32_t count = mip_levels(texture);
  if (count == 1) return levels;
  Level level = first_level(texture);
  while (levels.size() < count) {
    level = halved(level);
    levels.push_back(bytes_of(level, texture.srgb));
  }
  return levels;
}

std::uint32_t mip_levels(const Texture& texture) {
  return static_cast<std::uint32_t>(std::bit_width(std::max(texture.width, texture.height)));
}

std::uint64_t mip_bytes(const Texture& texture) {
  std::uint64_t bytes = 0;
  for (std::uint32_t i = 0; i < mip_levels(texture); ++i)
    bytes += std::uint64_t{4} * std::max(texture.width >> i, 1U) * std::max(texture.height >> i, 1U);
  return bytes;
}

}  // namespace fulcrum::render
