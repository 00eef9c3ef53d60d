#include "engine/assets/image.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum {
namespace {

constexpr std::uint32_t kLargestSide =
    8192;  // what every graphics device takes, and no file fills the memory

constexpr std::array<std::uint8_t, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 3> kJpeg{0xff, 0xd8, 0xff};

template <std::size_t N>
bool begins_with(std::span<const std::uint8_t> bytes, const std::array<std::uint8_t, N>& magic) {
  return bytes.size() >= N && std::equal(magic.begin(), magic.end(), bytes.begin());
}

Error damaged(const char* why) {
  return Error{std::string("it is damaged (") + why + "); export it again"};
}

std::optional<Error> refuse(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) return damaged("it has no pixels");
  if (width <= kLargestSide && height <= kLargestSide) return std::nullopt;
  return Error{"it is " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels: make it smaller, at most " + std::to_string(kLargestSide) + " a side"};
}

// The file without the chunks by which libpng would change its numbers: glTF 2.0, 3.8.3, has them ignored.
std::vector<std::uint8_t> without_colour_spaces(std::span<const std::uint8_t> encoded) {
  constexpr std::size_t kFrame = 12;  // bytes of a chunk beside its data: length, type, checksum
  std::vector<std::uint8_t> kept(encoded.begin(), encoded.begin() + kPng.size());
  for (std::size_t at = kPng.size(); at < encoded.size();) {
    const std::span<const std::uint8_t> left = encoded.subspan(at);
    std::size_t size = left.size();
    if (left.size() >= kFrame) {
      const std::size_t data = std::size_t{left[0]} << 24 | std::size_t{left[1]} << 16 |
                               std::size_t{left[2]} << 8 | std::size_t{left[3]};
      size = std::min(size, data + kFrame);
      const std::string_view type(reinterpret_cast<const char*>(left.data()) + 4, 4);
      at += size;
      if (type == "gAMA" || type == "sRGB" || type == "iCCP" || type == "cHRM") continue;
    } else {
      at += size;
    }
    kept.insert(kept.end(), left.begin(), left.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return kept;
}

// libpng's simplified interface, which needs no jumps over C++, reads these wrongly (1.6.39).
bool is_deep_and_interlaced(std::span<const std::uint8_t> png) {
  constexpr std::size_t kDepth = 24, kInterlace = 28;  // in the header, which comes first
  return png.size() > kInterlace && png[kDepth] == 16 && png[kInterlace] != 0;
}

Result<Image> decode_png(std::span<const std::uint8_t> as_written) {
  if (is_deep_and_interlaced(as_written))
    return Error{
        "it is interlaced, with 16 bits a colour, which is not supported: export it without interlacing"};
  const std::vector<std::uint8_t> encoded = without_colour_spaces(as_written);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto free = [](png_image* image) { png_image_free(image); };
  const std::unique_ptr<png_image, decltype(free)> guard(&png, free);
  if (png_image_begin_read_from_memory(&png, encoded.data(), encoded.size()) == 0)
    return damaged(png.message);
  if (const auto error = refuse(png.width, png.height)) return *error;
  png.format = PNG_FORMAT_RGBA;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  Image image{png.width, png.height, {}};
  image.rgba.resize(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) return damaged(png.message);
  return image;
}

Result<Image> decode_jpeg(std::span<const std::uint8_t> encoded) {
  const auto end = [](void* decoder) { tjDestroy(decoder); };
  const std::unique_ptr<void, decltype(end)> decoder(tjInitDecompress(), end);
  if (!decoder) return Error{"there is no memory left to read it: close other programs"};
  int width = 0, height = 0, subsampling = 0, colours = 0;
  const auto size = static_cast<unsigned long>(encoded.size());
  if (tjDecompressHeader3(decoder.get(), encoded.data(), size, &width, &height, &subsampling, &colours) != 0)
    return damaged(tjGetErrorStr2(decoder.get()));
  if (const auto error = refuse(static_cast<std::uint64_t>(std::max(width, 0)),
                                static_cast<std::uint64_t>(std::max(height, 0))))
    return *error;
  if (colours == TJCS_CMYK || colours == TJCS_YCCK)
    return Error{"it has the four colours of print, which are not supported: export it as RGB"};
  Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  image.rgba.resize(4 * std::size_t{image.width} * image.height);
  constexpr int kExact = TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS;
  if (tjDecompress2(decoder.get(), encoded.data(), size, image.rgba.data(), width, 0, height, TJPF_RGBA,
                    kExact) == 0)
    return image;
  // Some programs pad their files before a marker, and nothing is lost by that.
  const std::string why = tjGetErrorStr2(decoder.get());
  if (tjGetErrorCode(decoder.get()) == TJERR_WARNING && why.find("extraneous bytes") != std::string::npos)
    return image;
  return damaged(why.c_str());
}

}  // namespace

bool is_picture(std::span<const std::uint8_t> encoded) {
  return begins_with(encoded, kPng) || begins_with(encoded, kJpeg);
}

Result<Image> decode_image(std::span<const std::uint8_t> encoded) {
  return begins_with(encoded, kPng) ? decode_png(encoded) : decode_jpeg(encoded);
}

}  // namespace fulcrum
