#include "image_compare.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fulcrum::test {
namespace fs = std::filesystem;
using render::Picture;

namespace {

std::string size_of(const Picture& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

Picture difference(const Picture& a, const Picture& b) {
  Picture made{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    if (i % 4 != 3)
      made.rgba[i] = static_cast<std::uint8_t>(std::min(255, 16 * std::abs(a.rgba[i] - b.rgba[i])));
  return made;
}

// Writes FOLDER/NAME and says so, or why not.
std::string keep(const fs::path& folder, const std::string& name, const Picture& picture) {
  if (folder.empty()) return "";
  std::error_code ignored;  // writing says what is wrong
  fs::create_directories(folder, ignored);
  const std::optional<vulkan::Error> error = render::write_png(folder / name, picture);
  return error ? " " + error->sentence : " See " + (folder / name).string() + ".";
}

}  // namespace

vulkan::Result<Picture> read_png(const fs::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0)
    return vulkan::Error{"The picture " + file.string() + " cannot be read: " + image.message + "."};
  image.format = PNG_FORMAT_RGBA;
  Picture picture{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0)
    return vulkan::Error{"The picture " + file.string() + " is damaged: " + image.message + "."};
  return picture;
}

Comparison compare(const Picture& actual, const Picture& golden, const CompareOptions& options) {
  Comparison result;
  if (actual.width != golden.width || actual.height != golden.height) {
    result.sentence = "The picture is " + size_of(actual) + ", the golden one " + size_of(golden) + ".";
    return result;
  }
  for (std::size_t pixel = 0; pixel < actual.rgba.size(); pixel += 4) {
    int largest = 0;
    for (std::size_t channel = pixel; channel < pixel + 4; ++channel)
      largest = std::max(largest, std::abs(actual.rgba[channel] - golden.rgba[channel]));
    result.largest_lsb = std::max(result.largest_lsb, largest);
    result.pixels_by_one += largest == 1 ? 1 : 0;
    result.pixels_by_more += largest > 1 ? 1 : 0;
  }
  const std::size_t pixels = actual.rgba.size() / 4;
  const auto by_one =
      static_cast<std::size_t>(std::llround(options.max_share_by_one * static_cast<double>(pixels)));
  result.passed = result.largest_lsb <= options.max_lsb && result.pixels_by_more <= options.max_pixels &&
                  result.pixels_by_one <= by_one;
  result.sentence = "Of " + std::to_string(pixels) + " pixels " + std::to_string(result.pixels_by_one) +
                    " differ by 1 of 255 (allowed: " + std::to_string(by_one) + ") and " +
                    std::to_string(result.pixels_by_more) +
                    " by more (allowed: " + std::to_string(options.max_pixels) + "), at most by " +
                    std::to_string(result.largest_lsb) + " (allowed: " + std::to_string(options.max_lsb) +
                    ").";
  return result;
}

Comparison compare(const Picture& actual, const fs::path& golden, const CompareOptions& options) {
  const std::string name = golden.stem().string();
  const vulkan::Result<Picture> wanted = read_png(golden);
  if (!wanted) {
    Comparison missing;
    missing.sentence = wanted.error().sentence + keep(options.failure_folder, name + ".actual.png", actual);
    return missing;
  }
  Comparison result = compare(actual, *wanted, options);
  if (!result.passed) {
    result.sentence += keep(options.failure_folder, name + ".actual.png", actual);
    if (actual.rgba.size() == wanted->rgba.size())
      result.sentence += keep(options.failure_folder, name + ".diff.png", difference(actual, *wanted));
  }
  return result;
}

}  // namespace fulcrum::test
