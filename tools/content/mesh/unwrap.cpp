#include "tools/content/mesh/unwrap.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Round the solid of a triangle's corners, of which the last in a turn comes before the first: no corner is
// more than half a turn from the others. Negative: one on the axis, which is between the others.
std::array<double, 3> joined(std::array<double, 3> turns) {
  const double most = std::ranges::max(turns);
  double sum = 0.0;
  int count = 0;
  for (double& turn : turns) {
    if (turn < 0.0) continue;
    if (most - turn > 0.5) turn += 1.0;
    sum += turn;
    ++count;
  }
  for (double& turn : turns)
    if (turn < 0.0) turn = sum / count;
  return turns;
}

// m: how far along the solid each section is, round its corners in the mean.
std::vector<double> ways(const Solid& solid, std::size_t columns, std::size_t sections) {
  std::vector<double> result(sections, 0.0);
  for (std::size_t i = 1; i < sections; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < columns; ++k)
      sum += (solid.points[i * columns + k] - solid.points[(i - 1) * columns + k]).norm();
    result[i] = result[i - 1] + sum / static_cast<double>(columns);
  }
  return result;
}

template <typename TurnOf, typename WayOf>
CornerUv unwrapped(const Solid& solid, const Tiling& tiling, TurnOf turn_of, WayOf way_of) {
  CornerUv uv;
  for (const Triangle& t : solid.triangles) {
    const std::array<double, 3> turns = joined({turn_of(t[0]), turn_of(t[1]), turn_of(t[2])});
    auto& corners = uv.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {tiling.around * turns[k], tiling.first + way_of(t[k]) / tiling.height};
  }
  return uv;
}

}  // namespace

CornerUv unwrapped_sections(const Solid& solid, int columns, const Tiling& tiling) {
  const auto n = static_cast<std::size_t>(columns);
  const std::size_t sections = solid.points.size() / n, middles = sections * n;
  const std::vector<double> along = ways(solid, n, sections);
  return unwrapped(
      solid, tiling,
      [&](std::uint32_t i) {
        return i < middles ? static_cast<double>(i % n) / static_cast<double>(columns) : -1.0;
      },
      [&](std::uint32_t i) {
        if (i < middles) return along[i / n];
        const bool is_start = i == middles;
        const double radius = (solid.points[i] - solid.points[is_start ? 0 : middles - 1]).norm();
        return is_start ? -radius : along.back() + radius;
      });
}

CornerUv unwrapped_round(const Solid& solid, const Tiling& tiling) {
  constexpr double on_axis = 1e-6;  // m
  const auto radius = [&](std::uint32_t i) { return solid.points[i].head<2>().norm(); };
  return unwrapped(
      solid, tiling,
      [&](std::uint32_t i) {
        if (radius(i) < on_axis) return -1.0;
        const double turn = math::atan2(solid.points[i].y(), solid.points[i].x()) / (2.0 * pi);
        return turn < 0.0 ? turn + 1.0 : turn;
      },
      // Up the wall, and on inwards over the end.
      [&](std::uint32_t i) { return solid.points[i].z() - radius(i); });
}

CornerUv unwrapped_box(const Solid& solid, double size) {
  CornerUv uv;
  for (const Triangle& t : solid.triangles) {
    const Vector3d& a = solid.points[t[0]];
    Eigen::Index side = 0;
    (solid.points[t[1]] - a).cross(solid.points[t[2]] - a).cwiseAbs().maxCoeff(&side);
    auto& corners = uv.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& p = solid.points[t[k]];
      corners[k] = Vector2d(side == 0 ? p.y() : p.x(), side == 2 ? p.y() : p.z()) / size;
    }
  }
  return uv;
}

}  // namespace fulcrum::content
