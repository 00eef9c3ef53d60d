#pragma once
// A pointshell as spheres within spheres: node i of a level bounds points 16^k i to 16^k (i + 1) - 1, so that
// the tree needs no pointers. Single precision and sixteen to a block, as SIMD reads them.

#include <array>
#include <cstddef>
#include <vector>

#include "haptics/geometry/pointshell.h"

namespace fulcrum {

inline constexpr std::size_t kBlock = 16;

struct SphereTree {
  struct alignas(64) Points {
    std::array<float, kBlock> x, y, z;  // m from the patch's middle; NaN past the last point
  };
  struct alignas(64) Spheres {
    std::array<float, kBlock> x, y, z;  // p_T m, centres; NaN past the last node
    std::array<float, kBlock> radius;   // m, no point of the node is farther from the centre
  };
  std::vector<Points> patches;  // (n / 16) of the points
  // (n / 16) p_T m, exactly. What is small is rounded little: single precision takes nanometres off a point.
  std::vector<std::array<float, 3>> middles;
  double patch_radius = 0;                   // m, no point is farther from its patch's middle
  std::vector<std::vector<Spheres>> levels;  // the first bounds patches, the last is one block

  std::size_t bytes() const;
};

SphereTree build_sphere_tree(const Pointshell& shell_T);

}  // namespace fulcrum
