#pragma once
// Noise for pictures that go on where they end.

#include <Eigen/Core>
#include <cstdint>

namespace fulcrum::content {

// Smooth, of 0 to 1, 0.5 in the mean: random values at the corners of a grid of cells over 0 to 1 in u and in
// v, the same at opposite sides. Another seed, another noise.
double tileable_noise(const Eigen::Vector2d& uv, int cells_u, int cells_v, std::uint32_t seed);

}  // namespace fulcrum::content
