#include "tests/person/blobs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace fulcrum::person {
namespace {

void add(Blob& blob, int x, int y) {
  const Place at{static_cast<double>(x), static_cast<double>(y)};
  if (blob.pixels.empty()) {
    blob.left = blob.right = at.x;
    blob.top = blob.bottom = at.y;
  }
  blob.left = std::min(blob.left, at.x);
  blob.right = std::max(blob.right, at.x);
  blob.top = std::min(blob.top, at.y);
  blob.bottom = std::max(blob.bottom, at.y);
  blob.pixels.push_back(at);
}

// Which colour a pixel has, 0 for none, 1 for the first.
class Mask {
public:
  Mask(const Picture& picture, std::span<const Colour> colours, int tolerance)
      : width_(picture.width), height_(picture.height), of_(picture.rgb.size()) {
    std::size_t i = 0;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x, ++i) of_[i] = which(picture.at(x, y), colours, tolerance);
  }

  std::uint8_t& at(int x, int y) {
    return of_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

  // All that is joined to this pixel, and takes it out.
  Blob take(int x, int y) {
    Blob blob;
    const std::uint8_t colour = std::exchange(at(x, y), std::uint8_t{0});
    std::vector<std::pair<int, int>> next{{x, y}};
    while (!next.empty()) {
      const std::pair<int, int> here = next.back();
      next.pop_back();
      add(blob, here.first, here.second);
      for (int by = std::max(here.second - 1, 0); by <= std::min(here.second + 1, height_ - 1); ++by)
        for (int bx = std::max(here.first - 1, 0); bx <= std::min(here.first + 1, width_ - 1); ++bx)
          if (at(bx, by) == colour) {
            at(bx, by) = 0;
            next.emplace_back(bx, by);
          }
    }
    return blob;
  }

private:
  static std::uint8_t which(const Colour& seen, std::span<const Colour> colours, int tolerance) {
    for (std::size_t i = 0; i < colours.size(); ++i)
      if (std::abs(seen.red - colours[i].red) <= tolerance &&
          std::abs(seen.green - colours[i].green) <= tolerance &&
          std::abs(seen.blue - colours[i].blue) <= tolerance)
        return static_cast<std::uint8_t>(i + 1);
    return 0;
  }

  int width_, height_;
  std::vector<std::uint8_t> of_;
};

}  // namespace

double length(const Place& way) {
  return std::hypot(way.x, way.y);
}

std::vector<std::vector<Blob>> find_blobs(const Picture& picture, std::span<const Colour> colours,
                                          int tolerance) {
  Mask mask(picture, colours, tolerance);
  std::vector<std::vector<Blob>> found(colours.size());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (const std::uint8_t colour = mask.at(x, y); colour != 0)
        found[colour - 1U].push_back(mask.take(x, y));
  return found;
}

}  // namespace fulcrum::person
