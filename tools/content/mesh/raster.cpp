#include "tools/content/mesh/raster.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Most significant byte first, as PNG has all numbers.
void append_number(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

// CRC-32 of ISO/IEC 15948, annex D.
std::uint32_t crc_of(const Bytes& bytes, std::size_t first) {
  std::uint32_t crc = 0xffffffffU;
  for (std::size_t i = first; i < bytes.size(); ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return crc ^ 0xffffffffU;
}

void append_chunk(Bytes& png, std::string_view kind, const Bytes& body) {
  append_number(png, static_cast<std::uint32_t>(body.size()));
  const std::size_t first = png.size();
  png.insert(png.end(), kind.begin(), kind.end());
  png.insert(png.end(), body.begin(), body.end());
  append_number(png, crc_of(png, first));
}

// A zlib stream (RFC 1950) of blocks that are not compressed (RFC 1951, 3.2.4): what a compressor makes of
// the same bytes depends on its version, and a tape asks whether models are those that it was made with.
Bytes stored(const Bytes& bytes) {
  constexpr std::size_t most = 0xffff;  // bytes of a block
  Bytes stream{0x78, 0x01};
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (std::size_t first = 0; first < bytes.size(); first += most) {
    const std::size_t count = std::min(most, bytes.size() - first);
    stream.push_back(first + count == bytes.size() ? 1 : 0);
    for (const std::size_t length : {count, most - count}) {
      stream.push_back(static_cast<std::uint8_t>(length & 255U));
      stream.push_back(static_cast<std::uint8_t>(length >> 8U));
    }
    for (std::size_t i = first; i < first + count; ++i) {
      stream.push_back(bytes[i]);
      a = (a + bytes[i]) % 65521;
      b = (b + a) % 65521;
    }
  }
  append_number(stream, b << 16U | a);
  return stream;
}

}  // namespace

Raster::Raster(int columns, int rows)
    : width(columns),
      height(rows),
      rgb(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

void Raster::set(int column, int row, const Eigen::Vector3d& values) {
  const std::size_t first = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(column));
  for (std::size_t k = 0; k < 3; ++k)
    rgb[first + k] = static_cast<std::uint8_t>(
        std::lround(255.0 * std::clamp(values[static_cast<Eigen::Index>(k)], 0.0, 1.0)));
}

Eigen::Vector3d srgb_encoded(const Eigen::Vector3d& linear) {
  return linear.unaryExpr(
      [](double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * math::pow(c, 1.0 / 2.4) - 0.055; });
}

Eigen::Vector3d as_colour(const Eigen::Vector3d& normal) {
  return 0.5 * (normal + Eigen::Vector3d::Ones());
}

std::vector<std::uint8_t> png_of(const Raster& picture) {
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
  Bytes lines;
  for (std::size_t first = 0; first < picture.rgb.size(); first += row) {
    lines.push_back(0);  // no filter
    lines.insert(lines.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(first),
                 picture.rgb.begin() + static_cast<std::ptrdiff_t>(first + row));
  }
  Bytes header;
  append_number(header, static_cast<std::uint32_t>(picture.width));
  append_number(header, static_cast<std::uint32_t>(picture.height));
  header.insert(header.end(), {8, 2, 0, 0, 0});  // bits a channel, RGB; deflate, filters, not interlaced
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  append_chunk(png, "IHDR", header);
  append_chunk(png, "IDAT", stored(lines));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace fulcrum::content
