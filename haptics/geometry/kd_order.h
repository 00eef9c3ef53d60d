#pragma once
// An order in which points that are near in space are near in memory: median halving along the longest
// extent.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum {

// A permutation of the indices of `points`. Halves are cut at multiples of the largest power of 16 that both
// can have, so that every aligned run of 16, 256, 4096 ... is one cell of the halving. Ties are broken by
// index: same points, same order.
std::vector<std::uint32_t> kd_order(std::span<const Vec3> points);

}  // namespace fulcrum
