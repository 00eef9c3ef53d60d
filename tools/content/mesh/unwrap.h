#pragma once
// Where the corners of a solid's triangles lie in pictures: (u, v), (0, 0) at their top left, and beyond 0
// and 1 they repeat. Lines that a picture has along u run round what is turned, and along what is long.

#include <array>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

using CornerUv = std::vector<std::array<Eigen::Vector2d, 3>>;  // (m x 3) of each triangle's corners

// Pictures on a surface.
struct Tiling {
  int around = 1;       // times round it
  double height = 0.0;  // m, of one along it
  double first = 0.0;   // v where it begins
};

// Of a solid through sections of as many points each, which is closed at both ends: loft, lathe or tube.
CornerUv unwrapped_sections(const Solid& solid, int columns, const Tiling& tiling);

// Of any solid about the z axis.
CornerUv unwrapped_round(const Solid& solid, const Tiling& tiling);

// Of any solid along the x axis, each triangle as seen from that side of a box which it faces the most.
// size: m, of a picture.
CornerUv unwrapped_box(const Solid& solid, double size);

}  // namespace fulcrum::content
