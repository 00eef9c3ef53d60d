#pragma once
// Pictures for surfaces, and what paints them.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace fulcrum::content {

// Row by row from the top.
struct Raster {
  Raster(int columns, int rows);

  void set(int column, int row, const Eigen::Vector3d& values);  // of 0 to 1, as they are kept

  int width, height;              // pixels
  std::vector<std::uint8_t> rgb;  // (3 x width x height)
};

Eigen::Vector3d srgb_encoded(const Eigen::Vector3d& linear);
// Of a unit normal: x along u, y against v, z off the surface.
Eigen::Vector3d as_colour(const Eigen::Vector3d& normal);

// As the bytes of a PNG file, not compressed: the same picture gives the same ones everywhere.
std::vector<std::uint8_t> png_of(const Raster& picture);

}  // namespace fulcrum::content
