#include "engine/render/mip_chain.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

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

// What a colour that is not there weighs: where nothing is, it is all that is left.
constexpr float kNothing = 1e-4F;

struct Level {
  std::uint32_t width, height;
  std::vector<glm::vec4>
      pixels;  // linear; where the texture has holes, colours times alpha and a little more
};

// A texture's own pixels, one at a time: whole, in floats, the largest would take a gigabyte.
class FirstLevel {
public:
  explicit FirstLevel(const Texture& texture)
      : width(texture.width), height(texture.height), texture_(texture) {
    for (std::size_t i = 0; i < 256; ++i) {
      const float x = static_cast<float>(i) / 255.0F;
      decoded_[i] = texture.srgb ? linear_of(x) : x;
    }
  }

  glm::vec4 at(std::uint32_t x, std::uint32_t y) const {
    const std::uint8_t* pixel = &texture_.rgba[4 * (std::size_t{y} * width + x)];
    float alpha = static_cast<float>(pixel[3]) / 255.0F;
    if (texture_.cut_off) alpha = alpha < *texture_.cut_off ? 0.0F : 1.0F;
    const float weight = texture_.holes ? alpha + kNothing : 1.0F;
    return {weight * decoded_[pixel[0]], weight * decoded_[pixel[1]], weight * decoded_[pixel[2]], alpha};
  }

  std::uint32_t width, height;

private:
  const Texture& texture_;
  std::array<float, 256> decoded_{};
};

// Directions across a surface, as coordinates of 0 to 1, and the square of how far each leans.
class FirstRelief {
public:
  explicit FirstRelief(const Texture& texture)
      : width(texture.width), height(texture.height), texture_(texture) {}

  glm::vec4 at(std::uint32_t x, std::uint32_t y) const {
    const std::uint8_t* pixel = &texture_.rgba[4 * (std::size_t{y} * width + x)];
    const glm::vec3 coordinates = glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0F;
    const glm::vec2 leans = 2.0F * glm::vec2(coordinates) - 1.0F;
    return {coordinates, glm::dot(leans, leans)};
  }

  std::uint32_t width, height;

private:
  const Texture& texture_;
};

struct SmallerLevel {
  std::uint32_t width, height;
  const Level& level;

  glm::vec4 at(std::uint32_t x, std::uint32_t y) const { return level.pixels[std::size_t{y} * width + x]; }
};

// Of a side that is odd, the last pixel of the smaller one covers three.
template <class From>
Level halved(const From& from) {
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
        for (std::uint32_t column = left; column < right; ++column) sum += from.at(column, row);
      to.pixels.push_back(sum / static_cast<float>((bottom - top) * (right - left)));
    }
  }
  return to;
}

// The colour of a pixel of a texture with holes. Where nothing is there, it is that of what is there around
// it: between the two, a sampler mixes both.
glm::vec3 colour_there(const Level& level, std::uint32_t x, std::uint32_t y) {
  const auto pixel = [&](std::uint32_t column, std::uint32_t row) {
    return level.pixels[std::size_t{row % level.height} * level.width + column % level.width];
  };
  const glm::vec4 middle = pixel(x, y);
  if (middle.a > 0.0F) return glm::vec3(middle) / (middle.a + kNothing);
  glm::vec4 sum(0.0F);
  for (const std::uint32_t row : {y + level.height - 1, y, y + 1})
    for (const std::uint32_t column : {x + level.width - 1, x, x + 1}) sum += pixel(column, row);
  return glm::vec3(sum) / (sum.a + 9.0F * kNothing);
}

std::vector<std::uint8_t> bytes_of(const Level& level, const Texture& texture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * level.pixels.size());
  for (std::uint32_t y = 0; y < level.height; ++y)
    for (std::uint32_t x = 0; x < level.width; ++x) {
      const glm::vec4& pixel = level.pixels[std::size_t{y} * level.width + x];
      const glm::vec3 colour = texture.holes ? colour_there(level, x, y) : glm::vec3(pixel);
      for (int i = 0; i < 3; ++i) bytes.push_back(to_byte(texture.srgb ? encoded_of(colour[i]) : colour[i]));
      bytes.push_back(to_byte(pixel.a));
    }
  return bytes;
}

std::vector<std::uint8_t> relief_bytes_of(const Level& level) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * level.pixels.size());
  for (const glm::vec4& pixel : level.pixels) {
    for (int i = 0; i < 3; ++i) bytes.push_back(to_byte(pixel[i]));
    const glm::vec2 mean = 2.0F * glm::vec2(pixel) - 1.0F;
    bytes.push_back(to_byte(std::sqrt(std::max(pixel.a - glm::dot(mean, mean), 0.0F))));
  }
  return bytes;
}

// With all smaller levels behind the first, whose bytes `levels` has, and whose pixels `first` gives. bytes:
// makes those of a Level.
template <class First, class Bytes>
std::vector<std::vector<std::uint8_t>> continued(std::vector<std::vector<std::uint8_t>> levels,
                                                 const First& first, std::uint32_t count,
                                                 const Bytes& bytes) {
  if (count == 1) return levels;
  Level level = halved(first);
  levels.push_back(bytes(level));
  while (levels.size() < count) {
    level = halved(SmallerLevel{level.width, level.height, level});
    levels.push_back(bytes(level));
  }
  return levels;
}

}  // namespace

std::vector<std::vector<std::uint8_t>> mip_chain(const Texture& texture) {
  constexpr float kSteeper =
      8.0F;  // of edges: an alpha that is farther from the cut than a sixteenth is 0 or 1
  std::vector<std::uint8_t> own = texture.rgba;
  if (texture.cut_off)
    for (std::size_t i = 3; i < own.size(); i += 4)
      own[i] = to_byte(kCutOff + kSteeper * (static_cast<float>(own[i]) / 255.0F - *texture.cut_off));
  return continued({std::move(own)}, FirstLevel(texture), mip_levels(texture),
                   [&](const Level& level) { return bytes_of(level, texture); });
}

std::vector<std::vector<std::uint8_t>> relief_chain(const Texture& texture) {
  std::vector<std::uint8_t> own = texture.rgba;
  for (std::size_t i = 3; i < own.size(); i += 4) own[i] = 0;
  return continued({std::move(own)}, FirstRelief(texture), mip_levels(texture), relief_bytes_of);
}

glm::vec3 mean_colour(const Texture& texture) {
  const FirstLevel pixels(texture);
  glm::dvec3 sum(0.0);
  double weight = 0.0;
  for (std::uint32_t y = 0; y < pixels.height; ++y)
    for (std::uint32_t x = 0; x < pixels.width; ++x) {
      const glm::vec4 pixel = pixels.at(x, y);
      sum += glm::dvec3(pixel);
      weight += texture.holes ? static_cast<double>(pixel.a + kNothing) : 1.0;
    }
  return glm::vec3(sum / weight);
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
