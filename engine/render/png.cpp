#include <png.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "engine/render/picture.h"

namespace fulcrum::render {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// What is wrong is said by who called, and nothing of it printed.
[[noreturn]] void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void hush(png_structp, png_const_charp) {}

// libpng leaves by longjmp: this function holds nothing that would have to be destroyed.
bool write_rows(std::FILE* file, const Picture& picture) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, hush);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, file);
  png_set_compression_level(png, 1);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_IHDR(png, info, picture.width, picture.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  png_set_filler(png, 0, PNG_FILLER_AFTER);  // four bytes a pixel come in, three go out
  for (std::uint32_t y = 0; y < picture.height; ++y)
    png_write_row(png, &picture.rgba[std::size_t{y} * picture.width * 4]);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

std::optional<vulkan::Error> write_png(const std::filesystem::path& path, const Picture& picture) {
  std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "wb"));
  if (!file) {
    return vulkan::Error{"The picture " + path.string() +
                         " cannot be written; is the folder there, and writable?"};
  }
  const bool written = write_rows(file.get(), picture);
  if (std::fclose(file.release()) != 0 || !written) {
    // A torn picture goes; a device that stands under that name, such as /dev/full, stays.
    std::error_code fault;
    if (std::filesystem::is_regular_file(path, fault)) std::filesystem::remove(path, fault);
    return vulkan::Error{"The picture " + path.string() +
                         " could not be written to its end; is the disk full?"};
  }
  return {};
}

}  // namespace fulcrum::render
