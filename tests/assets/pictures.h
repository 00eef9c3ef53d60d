#pragma once
// Pictures of a few pixels, encoded in memory.

#include <png.h>
#include <turbojpeg.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace fulcrum::test {

// format: PNG_FORMAT_GRAY, PNG_FORMAT_RGB or PNG_FORMAT_RGBA.
inline std::vector<std::uint8_t> png_of(std::uint32_t width, std::uint32_t height, png_uint_32 format,
                                        const std::vector<std::uint8_t>& pixels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = width;
  png.height = height;
  png.format = format;
  std::vector<std::uint8_t> bytes(1 << 16);
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(png.message);
  bytes.resize(size);
  return bytes;
}

inline std::vector<std::uint8_t> jpeg_of(int width, int height, const std::vector<std::uint8_t>& rgb) {
  const tjhandle encoder = tjInitCompress();
  unsigned char* made = nullptr;
  unsigned long size = 0;
  const int fault = tjCompress2(encoder, rgb.data(), width, 0, height, TJPF_RGB, &made, &size, TJSAMP_444, 95,
                                TJFLAG_ACCURATEDCT);
  std::vector<std::uint8_t> bytes(made, made + size);
  tjFree(made);
  tjDestroy(encoder);
  if (fault != 0) throw std::runtime_error("a JPEG was not made");
  return bytes;
}

}  // namespace fulcrum::test
