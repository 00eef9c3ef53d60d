#include "tools/content/mesh/round_bar.h"

#include <algorithm>
#include <vector>

#include "haptics/math/functions.h"
#include "tools/content/mesh/tube.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double bend_step = 0.35 * mm;

// A round cap about `centre`: from near its pole to nearly the full radius.
std::vector<Station> cap(const Vector3d& centre, const Vector3d& outward, const Vector3d& tangent, double r,
                         int steps) {
  std::vector<Station> stations;
  for (int i = 0; i < steps; ++i) {
    const double angle = 0.5 * pi * (i + 0.25) / steps;
    stations.push_back({centre + r * math::cos(angle) * outward, tangent, r * math::sin(angle)});
  }
  return stations;
}

}  // namespace

Solid round_bar(std::span<const Stretch> stretches, double heading,
                const std::function<double(double)>& radius, const std::function<double(double)>& step,
                int columns) {
  Vector3d p = Vector3d::Zero();
  double along = 0.0;
  const auto direction = [&] { return Vector3d(0.0, math::cos(heading), math::sin(heading)); };
  std::vector<Station> line = cap(p, -direction(), direction(), radius(0.0), 6);
  for (const Stretch& stretch : stretches) {
    const double bend = stretch.turn / stretch.length;
    double rest = stretch.length;
    while (rest > 1e-9) {
      line.push_back({p, direction(), radius(along)});
      const double pace = std::min({step(along), rest, bend == 0.0 ? 1.0 : bend_step});
      heading += 0.5 * bend * pace;
      p += pace * direction();
      heading += 0.5 * bend * pace;
      along += pace;
      rest -= pace;
    }
  }
  const double r = radius(along);
  std::vector<Station> end = cap(p, direction(), direction(), r, 8);
  line.push_back({p, direction(), r});
  line.insert(line.end(), end.rbegin(), end.rend());
  // The flat ends of a tube have its plain radius: all but a speck of it is in the stations.
  constexpr double speck = 0.02 * mm;
  for (Station& station : line) station.swell -= speck;
  line.insert(line.begin(), {line.front().p - 1e-3 * mm * line.front().tangent, line.front().tangent, 0.0});
  line.push_back({line.back().p + 1e-3 * mm * line.back().tangent, line.back().tangent, 0.0});
  return tube(line, speck, columns, TubeEnd::flat, TubeEnd::flat);
}

}  // namespace fulcrum::content
