#include "haptics/geometry/kd_order.h"

#include <algorithm>
#include <numeric>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {
namespace {

constexpr std::size_t kRun = 16;

void halve(std::span<const Vec3> points, std::span<std::uint32_t> order) {
  if (order.size() <= kRun) return;
  Box3 box;
  for (const std::uint32_t i : order) box.extend(points[i]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  std::size_t unit = kRun;
  while (unit * kRun < order.size()) unit *= kRun;
  const std::size_t half = std::max(unit, (order.size() + unit) / (2 * unit) * unit);
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](std::uint32_t l, std::uint32_t r) {
                     return points[l][axis] < points[r][axis] ||
                            (points[l][axis] == points[r][axis] && l < r);
                   });
  halve(points, order.first(half));
  halve(points, order.subspan(half));
}

}  // namespace

std::vector<std::uint32_t> kd_order(std::span<const Vec3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  halve(points, order);
  return order;
}

}  // namespace fulcrum
