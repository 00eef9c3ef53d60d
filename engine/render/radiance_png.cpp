#include "engine/render/radiance_png.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace fulcrum::render {
namespace {

[[noreturn]] void leave_reading(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void hush_reading(png_structp, png_const_charp) {}

// The next bytes of the string_view that the reader has been given.
void take_bytes(png_structp png, png_bytep to, std::size_t size) {
  auto& left = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (left.size() < size) png_error(png, "it ends before");
  std::memcpy(to, left.data(), size);
  left.remove_prefix(size);
}

struct Samples {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> bytes;  // (height x width x 4 x 2) the high byte first
};

// libpng leaves by longjmp: what this function fills belongs to its caller.
bool read_samples(std::string_view& left, Samples& samples) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave_reading, hush_reading);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_set_user_limits(png, kMostRadiancePixels, kMostRadiancePixels);
  png_set_read_fn(png, &left, take_bytes);
  png_read_info(png, info);
  if (png_get_bit_depth(png, info) != 16 || png_get_color_type(png, info) != PNG_COLOR_TYPE_RGB_ALPHA ||
      png_get_interlace_type(png, info) != PNG_INTERLACE_NONE)
    png_error(png, "another kind");
  samples.width = png_get_image_width(png, info);
  samples.height = png_get_image_height(png, info);
  const std::size_t row = std::size_t{samples.width} * 8;
  // Row by row: a header may promise more than comes.
  for (std::uint32_t y = 0; y < samples.height; ++y) {
    samples.bytes.resize((y + 1) * row);
    png_read_row(png, &samples.bytes[y * row], nullptr);
  }
  png_read_end(png, nullptr);
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}

}  // namespace

vulkan::Result<Radiance> read_radiance(std::string_view png) {
  Samples samples;
  if (!read_samples(png, samples))
    return vulkan::Error{"it is no whole PNG of red, green, blue and alpha with 16 bits each, of at most " +
                         std::to_string(kMostRadiancePixels) + " pixels a side"};
  Radiance radiance{samples.width, samples.height, {}};
  radiance.pixels.reserve(samples.bytes.size() / 8);
  for (std::size_t at = 0; at < samples.bytes.size(); at += 8) {
    glm::vec4 v;
    for (int channel = 0; channel < 4; ++channel) {
      const std::size_t byte = at + 2 * static_cast<std::size_t>(channel);
      v[channel] = static_cast<float>(samples.bytes[byte] * 256 + samples.bytes[byte + 1]) / 65535.0F;
    }
    const glm::vec3 t = glm::vec3(v) * glm::vec3(v);
    radiance.pixels.push_back({t / std::max(1.0F - std::max({t.r, t.g, t.b}), 1e-4F), v.a});
  }
  return radiance;
}

}  // namespace fulcrum::render
