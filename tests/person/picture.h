#pragma once
// What a window shows, as a person's eye gets it: colours, and nothing else.

#include <cstdint>
#include <vector>

namespace fulcrum::person {

struct Place {
  double x = 0, y = 0;  // px from the top left, y down

  Place operator+(const Place& other) const { return {x + other.x, y + other.y}; }
  Place operator-(const Place& other) const { return {x - other.x, y - other.y}; }
  Place operator*(double factor) const { return {factor * x, factor * y}; }
};

double length(const Place& way);  // px

struct Colour {
  int red = 0, green = 0, blue = 0;  // 0..255
};

struct Picture {
  int width = 0, height = 0;       // px
  std::vector<std::uint32_t> rgb;  // (height x width) 0xRRGGBB, row by row

  Colour at(int x, int y) const {
    const std::uint32_t all =
        rgb[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    return {static_cast<int>(all >> 16U & 255U), static_cast<int>(all >> 8U & 255U),
            static_cast<int>(all & 255U)};
  }
};

}  // namespace fulcrum::person
