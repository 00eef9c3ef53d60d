#include "tools/content/mesh/tileable.h"

#include <cmath>

namespace fulcrum::content {
namespace {

// 0 to 1 for each corner of the grid: the finaliser of MurmurHash3 (A. Appleby, public domain).
double value_at(int i, int k, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9e3779b1U ^
                    static_cast<std::uint32_t>(k) * 0x85ebca77U ^ seed * 0xc2b2ae3dU;
  h = (h ^ h >> 16U) * 0x85ebca6bU;
  h = (h ^ h >> 13U) * 0xc2b2ae35U;
  return static_cast<double>((h ^ h >> 16U) >> 8U) / 16777216.0;
}

// Where in a cell, without a kink at its sides.
double eased(double t) {
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

}  // namespace

double tileable_noise(const Eigen::Vector2d& uv, int cells_u, int cells_v, std::uint32_t seed) {
  const double x = (uv.x() - std::floor(uv.x())) * cells_u, y = (uv.y() - std::floor(uv.y())) * cells_v;
  const int i = static_cast<int>(x) % cells_u, k = static_cast<int>(y) % cells_v;
  const int next_i = (i + 1) % cells_u, next_k = (k + 1) % cells_v;
  const double s = eased(x - std::floor(x)), t = eased(y - std::floor(y));
  return std::lerp(std::lerp(value_at(i, k, seed), value_at(next_i, k, seed), s),
                   std::lerp(value_at(i, next_k, seed), value_at(next_i, next_k, seed), s), t);
}

}  // namespace fulcrum::content
