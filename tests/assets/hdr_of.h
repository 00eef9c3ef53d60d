#pragma once
// Radiance pictures of a few pixels, encoded in memory.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::test {

using Rgb = std::array<float, 3>;

enum class HdrRows { flat, in_runs };

inline std::array<std::uint8_t, 4> rgbe_of(const Rgb& radiance) {
  const float brightest = *std::ranges::max_element(radiance);
  if (brightest < 1e-32F) return {0, 0, 0, 0};
  const int exponent = std::ilogb(brightest) + 1;
  std::array<std::uint8_t, 4> pixel{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
  for (std::size_t i = 0; i < 3; ++i)
    pixel[i] = static_cast<std::uint8_t>(std::ldexp(radiance[i], 8 - exponent));
  return pixel;
}

// Values one by one, and those that are alike, three or more, together.
inline void add_runs(std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& values) {
  for (std::size_t x = 0; x < values.size();) {
    std::size_t same = 1;
    while (x + same < values.size() && same < 127 && values[x + same] == values[x]) ++same;
    if (same > 2) {
      bytes.push_back(static_cast<std::uint8_t>(128 + same));
      bytes.push_back(values[x]);
      x += same;
    } else {
      bytes.push_back(1);
      bytes.push_back(values[x++]);
    }
  }
}

// value(column, row): of a pixel, rows from the top. Rows in runs have 8 pixels or more.
template <typename Value>
std::vector<std::uint8_t> hdr_of(std::uint32_t width, std::uint32_t height, HdrRows rows, const Value& value,
                                 const std::string& lines = "FORMAT=32-bit_rle_rgbe\n") {
  const std::string header =
      "#?RADIANCE\n" + lines + "\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  for (std::uint32_t y = 0; y < height; ++y) {
    std::vector<std::array<std::uint8_t, 4>> row;
    for (std::uint32_t x = 0; x < width; ++x) row.push_back(rgbe_of(value(x, y)));
    if (rows == HdrRows::flat) {
      for (const auto& pixel : row) bytes.insert(bytes.end(), pixel.begin(), pixel.end());
      continue;
    }
    bytes.insert(bytes.end(),
                 {2, 2, static_cast<std::uint8_t>(width >> 8U), static_cast<std::uint8_t>(width)});
    for (std::size_t channel = 0; channel < 4; ++channel) {
      std::vector<std::uint8_t> values;
      for (const auto& pixel : row) values.push_back(pixel[channel]);
      add_runs(bytes, values);
    }
  }
  return bytes;
}

}  // namespace fulcrum::test
